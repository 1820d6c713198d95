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
