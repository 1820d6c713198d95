#include "linear_algebra/thin_qr.hpp"

#include "core/expect.hpp"
#include "linear_algebra/tolerances.hpp"

#include <cmath>

namespace carom {

namespace {

/// In four sums: one would wait for each addition, and the compiler must not reorder.
double dot(const double* a, const double* b, int n)
{
    double sum[4] = {};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; ++k) sum[k] += a[i + k] * b[i + k];
    for (; i < n; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

double squared_norm(const std::vector<double>& a)
{
    return dot(a.data(), a.data(), static_cast<int>(a.size()));
}

}  // namespace

ThinQr::Split ThinQr::split(std::span<const double> column) const
{
    const int count = columns();
    Split out;
    out.residual.assign(column.begin(), column.end());
    out.along.assign(static_cast<std::size_t>(count), 0);
    double norm2 = squared_norm(out.residual);
    out.residual_norm2 = norm2;
    if (count == 0) return out;
    for (int pass = 0; pass < 2; ++pass) {
        std::vector<double> part(static_cast<std::size_t>(count));
        for (int j = 0; j < count; ++j) part[static_cast<std::size_t>(j)] = dot(q(j), out.residual.data(), rows_);
        for (int j = 0; j < count; ++j) {
            const double d = part[static_cast<std::size_t>(j)];
            out.along[static_cast<std::size_t>(j)] += d;
            const double* unit = q(j);
            for (int i = 0; i < rows_; ++i) out.residual[static_cast<std::size_t>(i)] -= d * unit[i];
        }
        out.residual_norm2 = squared_norm(out.residual);
        if (out.residual_norm2 > orthogonal_enough * norm2) break;
        norm2 = out.residual_norm2;
    }
    out.coefficients = out.along;
    back_substitute(out.coefficients);
    return out;
}

void ThinQr::append(const Split& column)
{
    CAROM_EXPECT(column.residual_norm2 > 0);
    const double norm = std::sqrt(column.residual_norm2);
    for (const double value : column.residual) basis_.push_back(value / norm);
    std::vector<double> edge = column.along;
    edge.push_back(norm);
    triangle_.push_back(std::move(edge));
}

void ThinQr::remove(int column)
{
    CAROM_EXPECT(0 <= column && column < columns());
    triangle_.erase(triangle_.begin() + column);
    // The columns behind it reach one below the diagonal: rotations of neighbouring rows lift them.
    for (int j = column; j < columns(); ++j) {
        const auto row = static_cast<std::size_t>(j);
        std::vector<double>& pivot = triangle_[row];
        const double r = std::sqrt(pivot[row] * pivot[row] + pivot[row + 1] * pivot[row + 1]);
        const double c = pivot[row] / r, s = pivot[row + 1] / r;
        // Sums only: gcc 12 with FMA instructions fuses a pair of a sum and a difference in spite of -ffp-contract=off.
        const double minus_s = -s;
        for (std::size_t k = row; k < triangle_.size(); ++k) {
            const double upper = triangle_[k][row], lower = triangle_[k][row + 1];
            triangle_[k][row] = c * upper + s * lower;
            triangle_[k][row + 1] = c * lower + minus_s * upper;
        }
        pivot.pop_back();
        double* first = q(j);
        double* second = q(j + 1);
        for (int i = 0; i < rows_; ++i) {
            const double upper = first[i], lower = second[i];
            first[i] = c * upper + s * lower;
            second[i] = c * lower + minus_s * upper;
        }
    }
    basis_.resize(basis_.size() - static_cast<std::size_t>(rows_));
}

void ThinQr::back_substitute(std::vector<double>& b) const
{
    for (std::size_t j = b.size(); j-- > 0;) {
        b[j] /= triangle_[j][j];
        for (std::size_t i = 0; i < j; ++i) b[i] -= triangle_[j][i] * b[j];
    }
}

std::vector<double> ThinQr::solve_normal(std::span<const double> b) const
{
    std::vector<double> out(b.begin(), b.end());
    for (std::size_t j = 0; j < out.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) out[j] -= triangle_[j][i] * out[i];
        out[j] /= triangle_[j][j];
    }
    back_substitute(out);
    return out;
}

}  // namespace carom
