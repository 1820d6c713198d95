#include "linear_algebra/block_cholesky.hpp"

#include "support/random.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

struct Sparse {
    int blocks = 0;
    std::vector<std::pair<int, int>> edges;
    std::vector<BlockCholesky::Column> columns;
};

Sparse random_sparse(Random& random, int blocks)
{
    Sparse out;
    out.blocks = blocks;
    for (int i = 0; i < blocks; ++i)
        for (int k = 0; k < 3; ++k) {
            const int j = k == 0 && i > 0 ? i - 1 : random.integer(-1, blocks - 1);
            if (j == i) continue;
            const Vec3 first = random.in_cube(3), second = j < 0 ? Vec3(Vec3::Zero()) : random.in_cube(3);
            if (j >= 0) out.edges.emplace_back(i, j);
            out.columns.push_back({i,
                                   j < 0 ? std::nullopt : std::optional(j),
                                   {first[0], first[1], first[2]},
                                   {second[0], second[1], second[2]}});
        }
    return out;
}

Eigen::VectorXd dense_column(const BlockCholesky::Column& column, int blocks)
{
    Eigen::VectorXd out = Eigen::VectorXd::Zero(3 * blocks);
    for (int k = 0; k < 3; ++k) {
        out[3 * column.a + k] = column.first[static_cast<std::size_t>(k)];
        if (column.b) out[3 * *column.b + k] = column.second[static_cast<std::size_t>(k)];
    }
    return out;
}

/// |A x - b| of the solution x of the factored matrix.
double residual(const BlockCholesky& factor, const Eigen::MatrixXd& matrix)
{
    const auto blocks = static_cast<std::size_t>(matrix.rows() / 3);
    std::vector<BlockCholesky::Vector> x(blocks, {1, -2, 3});
    factor.solve(x);
    Eigen::VectorXd b(matrix.rows()), solution(matrix.rows());
    for (std::size_t i = 0; i < blocks; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto row = static_cast<Eigen::Index>(3 * i + k);
            solution[row] = x[i][k];
            b[row] = k == 0 ? 1 : k == 1 ? -2 : 3;
        }
    return (matrix * solution - b).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("The factor solves what a dense matrix says")
{
    Random random(4);
    for (const int blocks : {1, 2, 7, 40}) {
        const Sparse sparse = random_sparse(random, blocks);
        BlockCholesky factor(blocks, sparse.edges);
        factor.factor(sparse.columns);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(3 * blocks, 3 * blocks);
        for (const auto& column : sparse.columns) {
            const Eigen::VectorXd c = dense_column(column, blocks);
            matrix += c * c.transpose();
        }
        CAPTURE(blocks);
        CHECK(residual(factor, matrix) < 1e-11);
    }
}
