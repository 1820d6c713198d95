#include "projection/dense_products.hpp"

namespace carom {

namespace {

double dot(const BlockCholesky::Vector& p, const BlockCholesky::Vector& q)
{
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

}  // namespace

double DenseProducts::product(std::size_t k, std::size_t l) const
{
    const UnitNormal &x = normals_[active_[k]], &y = normals_[active_[l]];
    double sum = 0;
    if (x.a == y.a) sum += dot(x.first, y.first);
    if (x.b && x.b == y.b) sum += dot(x.second, y.second);
    if (y.b == x.a) sum += dot(x.first, y.second);
    if (x.b == y.a) sum += dot(x.second, y.first);
    return sum;
}

bool DenseProducts::follow(const std::vector<char>& active)
{
    active_.clear();
    for (std::size_t i = 0; i < active.size(); ++i)
        if (active[i]) active_.push_back(i);
    const std::size_t n = active_.size();
    factor_.assign(n * n, 0);
    for (std::size_t j = 0; j < n; ++j) {
        factor_[j * n + j] = 1;
        for (std::size_t i = j + 1; i < n; ++i) factor_[j * n + i] = product(i, j);
    }
    for (std::size_t j = 0; j < n; ++j) {
        const double pivot = factor_[j * n + j];
        if (!(pivot > least_pivot)) return false;
        const double* column = &factor_[j * n];
        for (std::size_t k = j + 1; k < n; ++k) {
            if (column[k] == 0) continue;
            const double ratio = column[k] / pivot;
            double* below = &factor_[k * n];
            for (std::size_t i = k; i < n; ++i) below[i] -= ratio * column[i];
        }
    }
    return true;
}

std::vector<double> DenseProducts::multipliers(std::span<const double> wanted) const
{
    const std::size_t n = active_.size();
    std::vector<double> x;
    for (const std::size_t i : active_) x.push_back(wanted[i]);
    for (std::size_t j = 0; j < n; ++j) {
        const double* column = &factor_[j * n];
        x[j] /= column[j];
        for (std::size_t i = j + 1; i < n; ++i) x[i] -= column[i] * x[j];
    }
    for (std::size_t j = n; j-- > 0;) {
        const double* column = &factor_[j * n];
        double sum = 0;
        for (std::size_t i = j + 1; i < n; ++i) sum += column[i] * x[i];
        x[j] -= sum / column[j];
    }
    std::vector<double> out(normals_.size(), 0);
    for (std::size_t k = 0; k < n; ++k) out[active_[k]] = x[k];
    return out;
}

}  // namespace carom
