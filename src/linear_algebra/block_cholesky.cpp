#include "linear_algebra/block_cholesky.hpp"

#include "core/expect.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

using Block = BlockCholesky::Block;
using Vector = BlockCholesky::Vector;

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

/// target -= a b^T
void subtract_product(const Block& a, const Block& b, Block& target)
{
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            target[3 * r + c] -= a[3 * r] * b[3 * c] + a[3 * r + 1] * b[3 * c + 1] + a[3 * r + 2] * b[3 * c + 2];
}

/// The lower triangle of the Cholesky factor; above it zeros.
void factor_block(Block& m)
{
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < c; ++k)
            for (std::size_t r = c; r < 3; ++r) m[3 * r + c] -= m[3 * r + k] * m[3 * c + k];
        CAROM_EXPECT(m[3 * c + c] > 0);
        m[3 * c + c] = std::sqrt(m[3 * c + c]);
        for (std::size_t r = c + 1; r < 3; ++r) m[3 * r + c] /= m[3 * c + c];
        for (std::size_t r = 0; r < c; ++r) m[3 * r + c] = 0;
    }
}

/// m <- m l^-T, l lower triangular
void divide_right(const Block& l, Block& m)
{
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) {
            for (std::size_t k = 0; k < c; ++k) m[3 * r + c] -= m[3 * r + k] * l[3 * c + k];
            m[3 * r + c] /= l[3 * c + c];
        }
}

}  // namespace

BlockCholesky::BlockCholesky(int blocks, const std::vector<std::pair<int, int>>& edges)
    : pattern_(block_pattern(blocks, edges)), blocks_(pattern_->rows.size())
{
}

void BlockCholesky::factor(std::span<const Column> columns)
{
    const std::vector<int>&place = pattern_->place, &begin = pattern_->begin, &rows = pattern_->rows,
          &left_begin = pattern_->left_begin;
    std::fill(blocks_.begin(), blocks_.end(), Block{});
    const auto add = [](const Vector& u, const Vector& v, Block& block) {
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c) block[3 * r + c] += u[r] * v[c];
    };
    const auto diagonal = [&](int j) -> Block& { return blocks_[at(begin[at(j)])]; };
    for (const Column& c : columns) {
        const int a = place[at(c.a)];
        add(c.first, c.first, diagonal(a));
        if (!c.b) continue;
        const int b = place[at(*c.b)];
        add(c.second, c.second, diagonal(b));
        const int left = std::min(a, b), below = std::max(a, b);
        const auto found = std::lower_bound(rows.begin() + begin[at(left)], rows.begin() + begin[at(left) + 1], below);
        CAROM_EXPECT(found != rows.end() && *found == below);
        Block& block = blocks_[at(static_cast<int>(found - rows.begin()))];
        if (a < b)
            add(c.second, c.first, block);
        else
            add(c.first, c.second, block);
    }
    const int count = static_cast<int>(place.size());
    std::vector<int> where(at(count));
    for (int j = 0; j < count; ++j) {
        Block& pivot = diagonal(j);
        for (std::size_t k = 0; k < 3; ++k) pivot[4 * k] += 1;
        for (int p = begin[at(j)]; p < begin[at(j) + 1]; ++p) where[at(rows[at(p)])] = p;
        for (int q = left_begin[at(j)]; q < left_begin[at(j) + 1]; ++q) {
            const BlockPattern::Left& left = pattern_->left[at(q)];
            const Block across = blocks_[at(left.at)];
            for (int p = left.at; p < begin[at(left.column) + 1]; ++p)
                subtract_product(blocks_[at(p)], across, blocks_[at(where[at(rows[at(p)])])]);
        }
        factor_block(pivot);
        for (int p = begin[at(j)] + 1; p < begin[at(j) + 1]; ++p) divide_right(pivot, blocks_[at(p)]);
    }
}

int BlockCholesky::first_of(const Column& column) const
{
    const int a = pattern_->place[at(column.a)];
    return column.b ? std::min(a, pattern_->place[at(*column.b)]) : a;
}

std::optional<int> BlockCholesky::parent_of(int block) const
{
    const int first = pattern_->begin[at(block)], last = pattern_->begin[at(block) + 1];
    return last - first > 1 ? std::optional(pattern_->rows[at(first + 1)]) : std::nullopt;
}

double BlockCholesky::update_cost(const Column& column) const
{
    double cost = 0;
    for (std::optional<int> j = first_of(column); j; j = parent_of(*j)) {
        const int size = pattern_->begin[at(*j) + 1] - pattern_->begin[at(*j)];
        cost += 18 * size;
    }
    return cost;
}

void BlockCholesky::update(const Column& column, double sign)
{
    const std::vector<int>&place = pattern_->place, &begin = pattern_->begin, &rows = pattern_->rows;
    std::vector<Vector> w(place.size(), Vector{});
    w[at(place[at(column.a)])] = column.first;
    if (column.b) w[at(place[at(*column.b)])] = column.second;
    // The update goes along the path, a scalar column after the other.
    for (std::optional<int> next = first_of(column); next; next = parent_of(*next)) {
        const int j = *next;
        const int first = begin[at(j)], last = begin[at(j) + 1];
        Block& pivot = blocks_[at(first)];
        for (std::size_t c = 0; c < 3; ++c) {
            const double l = pivot[4 * c], x = w[at(j)][c];
            const double square = l * l + sign * x * x;
            // Rounding may leave less than the unit matrix, which is never taken away.
            const double r = std::sqrt(std::max(square, 1.0));
            const double cosine = r / l, sine = x / l;
            pivot[4 * c] = r;
            for (std::size_t k = c + 1; k < 3; ++k) {
                double& entry = pivot[3 * k + c];
                entry = (entry + sign * sine * w[at(j)][k]) / cosine;
                w[at(j)][k] = cosine * w[at(j)][k] - sine * entry;
            }
            for (int p = first + 1; p < last; ++p) {
                Vector& below = w[at(rows[at(p)])];
                Block& block = blocks_[at(p)];
                for (std::size_t k = 0; k < 3; ++k) {
                    double& entry = block[3 * k + c];
                    entry = (entry + sign * sine * below[k]) / cosine;
                    below[k] = cosine * below[k] - sine * entry;
                }
            }
        }
    }
}

void BlockCholesky::solve(std::span<Vector> b) const
{
    const std::vector<int>&place = pattern_->place, &begin = pattern_->begin, &rows = pattern_->rows;
    const int count = static_cast<int>(place.size());
    std::vector<Vector> x(place.size());
    for (int i = 0; i < count; ++i) x[at(place[at(i)])] = b[at(i)];
    for (int j = 0; j < count; ++j) {
        const Block& l = blocks_[at(begin[at(j)])];
        Vector& mine = x[at(j)];
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t k = 0; k < r; ++k) mine[r] -= l[3 * r + k] * mine[k];
            mine[r] /= l[4 * r];
        }
        for (int p = begin[at(j)] + 1; p < begin[at(j) + 1]; ++p) {
            Vector& below = x[at(rows[at(p)])];
            const Block& block = blocks_[at(p)];
            for (std::size_t r = 0; r < 3; ++r)
                below[r] -= block[3 * r] * mine[0] + block[3 * r + 1] * mine[1] + block[3 * r + 2] * mine[2];
        }
    }
    for (int j = count - 1; j >= 0; --j) {
        const Block& l = blocks_[at(begin[at(j)])];
        Vector& mine = x[at(j)];
        for (int p = begin[at(j)] + 1; p < begin[at(j) + 1]; ++p) {
            const Vector& below = x[at(rows[at(p)])];
            const Block& block = blocks_[at(p)];
            for (std::size_t c = 0; c < 3; ++c)
                mine[c] -= block[c] * below[0] + block[3 + c] * below[1] + block[6 + c] * below[2];
        }
        for (std::size_t r = 3; r-- > 0;) {
            for (std::size_t k = r + 1; k < 3; ++k) mine[r] -= l[3 * k + r] * mine[k];
            mine[r] /= l[4 * r];
        }
    }
    for (int i = 0; i < count; ++i) b[at(i)] = x[at(place[at(i)])];
}

}  // namespace carom
