// SPDX-License-Identifier: BSL-1.0
// Matrices of every pattern are solved with, those that are singular to rounding are refused, and rows may be of any size.
#include <random>

#include <Eigen/Core>
#include <doctest/doctest.h>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/multiprecision.hpp"

namespace linear_tests {

using namespace hilger;
using namespace hilger::detail;

namespace {

using places = std::vector<std::pair<int, int>>;
places full(int d) { // 0 on the diagonal: there are no steps without exchanging rows
    places all;
    for (int j = 0; j < d; ++j)
        for (int k = 0; k < d; ++k)
            if (j != k) all.emplace_back(j, k);
    return all;
}
places band(int d, int below, int above) {
    places all;
    for (int j = 0; j < d; ++j)
        for (int k = std::max(0, j - below); k <= std::min(d - 1, j + above); ++k) all.emplace_back(j, k);
    return all;
}
places ring(int d) {
    auto all = band(d, 1, 1);
    all.emplace_back(0, d - 1);
    all.emplace_back(d - 1, 0);
    return all;
}
/// |x - y| / |x| for y in K y = K x, with small whole numbers in K.
template <class S>
S error_of(int d, places const& entries, unsigned seed) {
    std::mt19937 random(seed);
    patterned_matrix<S> K;
    K.prepare(d, entries);
    K.set_zero();
    Eigen::Matrix<S, Eigen::Dynamic, 1> x(d), y(d);
    for (int k = 0; k < d; ++k) {
        x(k) = S(static_cast<int>(random() % 9) + 1);
        y(k) = S(0);
    }
    for (auto const& [j, k] : entries) {
        S const entry = S(static_cast<int>(random() % 7) - 3) + (j == k ? S(1) / S(8) : S(0)); // weak diagonals
        K[K.place(j, k)] += entry;
        y(j) += entry * x(k);
    }
    if (not K.factorize()) return S(-1);
    CHECK(K.factorize()); // of the entries, again
    K.solve(y);
    return S((y - x).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff());
}

} // namespace

TEST_CASE("every pattern, exactly in rational numbers") {
    int solved = 0;
    for (unsigned seed = 0; seed < 12; ++seed)
        for (auto const& [d, entries] :
             {std::pair{1, band(1, 0, 0)}, std::pair{4, full(4)}, std::pair{9, full(9)}, std::pair{12, band(12, 0, 0)},
              std::pair{12, band(12, 1, 1)}, std::pair{20, band(20, 2, 1)}, std::pair{20, band(20, 1, 3)}}) {
            Q const error = error_of<Q>(d, entries, seed);
            if (error < 0) continue; // singular
            CHECK(error == 0);
            ++solved;
        }
    CHECK(solved > 60);
}
TEST_CASE("every pattern and solver, to rounding") {
    for (unsigned seed = 0; seed < 8; ++seed)
        for (auto const& [d, entries] :
             {std::pair{16, full(16)}, std::pair{17, full(17)}, std::pair{40, full(40)}, std::pair{40, band(40, 0, 0)},
              std::pair{60, ring(60)}, std::pair{60, band(60, 1, 1)}, std::pair{50, band(50, 3, 2)}}) {
            double const error = error_of<double>(d, entries, seed);
            CHECK(error >= 0);
            CHECK(error <= 1e-9); // K is whole numbers at random: its condition is what it happens to be
        }
}
TEST_CASE("what is singular to rounding is refused, and what is small is not singular") {
    Eigen::Matrix3d K;
    K << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    CHECK(not invert(K));
    K << 1e-200, 0, 0, 0, 1e100, 1, 0, 0, 1e-100;
    CHECK(invert(K));
    CHECK(K(0, 0) == 1 / 1e-200);
    Eigen::MatrixXd all = Eigen::MatrixXd::Constant(5, 5, 1.0);
    CHECK(not invert(all));
    all.diagonal().setConstant(2);
    Eigen::MatrixXd const before = all;
    CHECK(invert(all));
    CHECK((all * before - Eigen::MatrixXd::Identity(5, 5)).cwiseAbs().maxCoeff() <= 64 * epsilon<double>());
    Eigen::Matrix<Q, 2, 2> swapped;
    swapped << 0, 2, 3, 0;
    CHECK(invert(swapped));
    CHECK(swapped(0, 1) == Q(1, 3));
    CHECK(swapped(1, 0) == Q(1, 2));
    for (auto const& entries : {ring(60), full(20), band(30, 1, 1), band(30, 0, 0)}) {
        patterned_matrix<double> zero;
        int const d = entries.back().first + 1;
        zero.prepare(d, entries);
        zero.set_zero();
        CHECK(not zero.factorize());
        CHECK(not zero.is_factorized());
    }
}
TEST_CASE("rows are weighed, and pivots without a digit are seen, by every solver") {
    for (auto const& [d, entries] :
         {std::pair{60, ring(60)}, std::pair{20, full(20)}, std::pair{9, full(9)}, std::pair{60, band(60, 1, 1)}})
        for (bool const regular : {true, false}) {
            patterned_matrix<double> K;
            K.prepare(d, entries);
            K.set_zero();
            // differences of neighbours: constants are in the kernel, unless one row has something more; rows of very different sizes
            for (auto const& [j, k] : entries)
                if (j != k) {
                    double const size = j == 3 ? 1e-30 : j == 5 ? 1e40 : 1 + 0.1 * (j + k);
                    K[K.place(j, k)] -= size;
                    K[K.place(j, j)] += size;
                }
            if (regular) K[K.place(3, 3)] += 1e-30;
            int const size_of_it = d;
            CAPTURE(size_of_it);
            CHECK(K.factorize() == regular);
        }
}
TEST_CASE("a copy makes factors of its own") {
    patterned_matrix<double> K;
    auto const entries = ring(60);
    K.prepare(60, entries);
    for (int k = 0; k < 60; ++k) K[K.place(k, k)] = 2;
    CHECK(K.factorize());
    patterned_matrix<double> copy = K;
    if (not copy.is_factorized()) CHECK(copy.factorize());
    Eigen::VectorXd x = Eigen::VectorXd::Constant(60, 3.0);
    copy.solve(x);
    CHECK(x(7) == 1.5);
}
TEST_CASE("a matrix that is assigned to has the numbers and the pattern of the other") {
    auto const with = [](std::vector<std::pair<int, int>> const& entries, double factor) {
        patterned_matrix<double> K;
        K.prepare(60, entries);
        for (auto const& [j, k] : entries) K[K.place(j, k)] = j == k ? 4 * factor : factor;
        CHECK(K.factorize());
        return K;
    };
    auto const twice = [](std::vector<std::pair<int, int>> entries) { // the ring, and second neighbours
        for (int k = 0; k < 60; ++k) entries.emplace_back(k, (k + 2) % 60);
        return entries;
    };
    auto K = with(ring(60), 1);
    for (auto const& [other, sum] : {std::pair{with(ring(60), 3), 18.0}, std::pair{with(twice(ring(60)), 1), 7.0}}) {
        K = other;
        if (not K.is_factorized()) CHECK(K.factorize());
        Eigen::VectorXd x = Eigen::VectorXd::Constant(60, sum);
        K.solve(x);
        CHECK((x - Eigen::VectorXd::Ones(60)).cwiseAbs().maxCoeff() <= 64 * epsilon<double>());
    }
}
TEST_CASE("a matrix whose size is bounded is solved with as any") {
    for (auto const& entries : {full(9), band(9, 0, 0), band(16, 1, 0), full(16)}) {
        int const d = entries.back().first + 1;
        patterned_matrix<Q, 16> bounded;
        patterned_matrix<Q> any;
        bounded.prepare(d, entries);
        any.prepare(d, entries);
        for (auto const& [j, k] : entries) bounded[bounded.place(j, k)] = any[any.place(j, k)] = j == k ? Q(d + j) : Q(1, 1 + j + k);
        CHECK(bounded.factorize());
        CHECK(any.factorize());
        Eigen::Matrix<Q, Eigen::Dynamic, 1> x(d), y(d);
        for (int k = 0; k < d; ++k) x(k) = y(k) = Q(k, 3);
        bounded.solve(x);
        any.solve(y);
        CHECK(x == y);
    }
}

} // namespace linear_tests
