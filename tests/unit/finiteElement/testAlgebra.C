/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of Vec, Ten and pack, and of a field operator of OpenFOAM that some
    compilers get wrong.
\*---------------------------------------------------------------------------*/

#include "feTensor.H"
#include "feSimd.H"
#include "vectorField.H"
#include "tensorField.H"
#include "Random.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

template<class T, int d>
Ten<T, d> example()
{
    Ten<T, d> A;
    for (int i = 0; i < d; ++i) for (int j = 0; j < d; ++j)
    {
        A(i, j) = T((i == j ? 2.0 : 0.0) + 0.3*i - 0.7*j + 0.1*i*j);
    }
    return A;
}

template<int d>
void testInverse()
{
    const auto A = example<double, d>();
    const auto I = A & inv(A), J = inv(A) & A;
    for (int i = 0; i < d; ++i) for (int j = 0; j < d; ++j)
    {
        EXPECT_NEAR(I(i, j), i == j, 1e-15*10);
        EXPECT_NEAR(J(i, j), i == j, 1e-15*10);
    }
    EXPECT_NEAR(det(inv(A)), 1/det(A), 1e-14);
    EXPECT_NEAR(det(A & A), det(A)*det(A), 1e-13);
    EXPECT_EQ(det(Ten<double, d>::I()), 1);

    // d det/dA = det A^-T
    const double h = 1e-6;
    for (int i = 0; i < d; ++i) for (int j = 0; j < d; ++j)
    {
        auto plus = A, minus = A;
        plus(i, j) += h;
        minus(i, j) -= h;
        EXPECT_NEAR((det(plus) - det(minus))/(2*h), det(A)*inv(A)(j, i), 1e-8);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(algebra, inverseAndDeterminant)
{
    testInverse<1>();
    testInverse<2>();
    testInverse<3>();
}


TEST(algebra, productsAreThoseOfOpenFOAM)
{
    const auto A = example<double, 3>();
    const Ten<double, 3> B = A & A.t();
    const Vec<double, 3> u{{0.3, -1.2, 2}}, v{{1, 0.4, -0.6}};
    const auto toFoam = [](const Ten<double, 3>& X)
    {
        return tensor(X(0,0), X(0,1), X(0,2), X(1,0), X(1,1), X(1,2), X(2,0), X(2,1), X(2,2));
    };
    const tensor a = toFoam(A), b = toFoam(B);
    const vector p(u[0], u[1], u[2]), q(v[0], v[1], v[2]);
    const auto near = [](const Vec<double, 3>& x, const vector& y)
    {
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(x[i], y[i], 1e-14);
    };
    near(A & u, a & p);
    near(u & A, p & a);
    near(2*u - v*0.5, 2*p - 0.5*q);
    EXPECT_NEAR(u & v, p & q, 1e-15);
    EXPECT_NEAR(A && B, a && b, 1e-13);
    EXPECT_NEAR(tr(A), Foam::tr(a), 1e-15);
    EXPECT_NEAR(det(A), Foam::det(a), 1e-14);
    EXPECT_LT(mag(toFoam(A & B) - (a & b)), 1e-13);
    EXPECT_LT(mag(toFoam(u*v) - p*q), 1e-15);
    EXPECT_LT(mag(toFoam(inv(A)) - Foam::inv(a)), 1e-14);
    EXPECT_LT(mag(toFoam(A.t()) - a.T()), 1e-15);
}


TEST(algebra, traceOfPlaneStrain)
{
    const auto C2 = example<double, 2>();
    const auto C3 = example<double, 3>();
    EXPECT_EQ(trPlaneStrain(C2), tr(C2) + 1);
    EXPECT_EQ(trPlaneStrain(C3), tr(C3));
}


TEST(algebra, lanesOfAPackAreIndependent)
{
    Ten<pack, 3> A;
    for (int l = 0; l < packSize; ++l)
    {
        const auto a = (1 + 0.25*l)*example<double, 3>();
        for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j) A(i, j)[l] = a(i, j);
    }
    const auto B = inv(A);
    const pack d = det(A);
    double largest = -1e300, smallest = 1e300;
    for (int l = 0; l < packSize; ++l)
    {
        const auto a = (1 + 0.25*l)*example<double, 3>();
        const auto b = inv(a);
        EXPECT_NEAR(d[l], det(a), 1e-13*det(a));
        for (int i = 0; i < 3; ++i) for (int j = 0; j < 3; ++j) EXPECT_NEAR(B(i, j)[l], b(i, j), 1e-14);
        largest = std::max(largest, double(d[l]));
        smallest = std::min(smallest, double(d[l]));
    }
    EXPECT_EQ(maxLane(d), largest);
    EXPECT_EQ(minLane(d), smallest);
}


//- g++ 12 at -O3 gets this wrong unless __restrict__ is taken away: the result
//  takes the storage of the temporary (etc/wmakeRules)
TEST(algebra, fieldOperatorsOnTemporaries)
{
    Foam::Random random(1);
    vectorField u(101);
    tensorField A(101);
    for (vector& v : u) v = random.GaussNormal<vector>();
    for (tensor& t : A) t = random.GaussNormal<tensor>();

    const vectorField left(tmp<vectorField>(new vectorField(u)) & A);
    const vectorField right(A & tmp<vectorField>(new vectorField(u)));
    const vectorField chain(((u + u) & A) - (A & (u - 0.5*u)));
    forAll(u, i)
    {
        EXPECT_LT(mag(left[i] - (u[i] & A[i])), 1e-14);
        EXPECT_LT(mag(right[i] - (A[i] & u[i])), 1e-14);
        EXPECT_LT(mag(chain[i] - (2*(u[i] & A[i]) - 0.5*(A[i] & u[i]))), 1e-13);
    }
}


// ************************************************************************* //
