/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of gmres and andersonSteps with a small unsymmetric matrix, its
    unknowns on any number of ranks, some on several.
\*---------------------------------------------------------------------------*/

#include "gmres.H"
#include "andersonSteps.H"
#include "gatherAll.H"
#include "trapsOff.H"
#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <limits>

using namespace Foam;

namespace
{

typedef Eigen::MatrixXd matrix;
typedef Eigen::VectorXd column;

const label n = 8;

//- Every rank has the n unknowns but those of a few nodes, which are others';
//  vectors are consistent
struct smallSystem
{
    nodeMap map;
    matrix A;
    column b;

    smallSystem()
    :
        map(keys(), labelList(keys().size(), 1)),
        A(n, n),
        b(n)
    {
        for (label i = 0; i < n; ++i)
        {
            b[i] = ::cos(2.0*i) + 0.3;
            for (label j = 0; j < n; ++j) A(i, j) = (i == j ? 3 : 0) + ::sin(1.0 + 2.3*i*j + 5.3*j*j + 0.7*i);
        }
    }

    //- Keys are the rows and columns of A
    static labelList keys()
    {
        labelList key;
        for (label k = 0; k < n; ++k)
        {
            if (k % Pstream::nProcs() == Pstream::myProcNo() || k % 3 == 0) key.append(k);
        }
        return key;
    }

    scalarField field(const column& x) const
    {
        scalarField f(map.nUnknowns());
        forAll(f, u) f[u] = x[map.key(u)];
        return f;
    }

    column dense(const scalarField& f) const
    {
        scalarField all(n, 0);
        for (const label u : map.ownedUnknowns()) all[map.key(u)] = f[u];
        Pstream::listCombineGather(all, plusEqOp<scalar>());
        Pstream::listCombineScatter(all);
        return Eigen::Map<const column>(all.cdata(), n);
    }

    //- Number of iterations; x set
    label solve
    (
        const matrix& A, const matrix& Minv,
        const scalar tolerance, const label limit, column& x, const column& rhs
    )
    {
        gmres solver(map, n);
        scalarField f(map.nUnknowns(), 7);  // no guess
        const label nIterations = solver.solve
        (
            [&](const scalarField& x, scalarField& y) { y = field(A*dense(x)); },
            [&](const scalarField& x, scalarField& y) { y = field(Minv*dense(x)); },
            field(rhs), f, tolerance, limit
        );
        x = dense(f);
        return nIterations;
    }

    label solve(const scalar tolerance, const label limit, column& x)
    {
        return solve(A, matrix::Identity(n, n), tolerance, limit, x, b);
    }

    //- Smallest residual in the Krylov space of k vectors
    scalar smallest(const label k) const
    {
        matrix V(n, k), AV;
        V.col(0) = b.normalized();
        for (label i = 1; i < k; ++i) V.col(i) = (A*V.col(i - 1)).normalized();
        AV = A*V;
        return (b - AV*AV.colPivHouseholderQr().solve(b)).norm();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(gmres, isExactInAsManyStepsAsUnknowns)
{
    smallSystem s;
    EXPECT_GT((s.A - s.A.transpose()).norm(), 1);
    column x;
    EXPECT_EQ(s.solve(1e-12, n, x), n);
    EXPECT_LT((s.A*x - s.b).norm(), 1e-12*s.b.norm());
    EXPECT_LT((x - s.A.lu().solve(s.b)).norm(), 1e-11*x.norm());
}


TEST(gmres, stopsAtTheTolerance)
{
    smallSystem s;
    label before = 0;
    for (const scalar tolerance : {0.9, 0.3, 0.1, 1e-2})
    {
        SCOPED_TRACE(tolerance);
        column x;
        const label k = s.solve(tolerance, n, x);
        EXPECT_LE((s.A*x - s.b).norm(), tolerance*s.b.norm()*(1 + 1e-12));
        EXPECT_GE(k, before);
        EXPECT_LE(k, n);
        before = k;

        // No step too many
        EXPECT_GE(k, 1);
        if (k > 1) { EXPECT_GT(s.smallest(k - 1), tolerance*s.b.norm()); }
    }
    EXPECT_GT(before, 2);
}


TEST(gmres, tellsThatTheLimitWasReached)
{
    smallSystem s;
    for (label limit = 1; limit < n; ++limit)
    {
        SCOPED_TRACE(limit);
        column x;
        EXPECT_EQ(s.solve(1e-12, limit, x), limit + 1);

        // The best that so many steps can do
        EXPECT_NEAR((s.A*x - s.b).norm(), s.smallest(limit), 1e-9*s.b.norm());
    }
    column x;
    EXPECT_EQ(s.solve(1e-12, 0, x), 1);
    EXPECT_EQ(x.norm(), 0);
}


TEST(gmres, aZeroRightHandSideHasNoSteps)
{
    smallSystem s;
    column x;
    EXPECT_EQ(s.solve(s.A, matrix::Identity(n, n), 1e-12, n, x, column::Zero(n)), 0);
    EXPECT_EQ(x.norm(), 0);
}


TEST(gmres, isPreconditionedFromTheRight)
{
    smallSystem s;
    const matrix inverse = s.A.inverse();
    column x;
    EXPECT_EQ(s.solve(s.A, inverse, 1e-12, n, x, s.b), 1);
    EXPECT_LT((s.A*x - s.b).norm(), 1e-12*s.b.norm());

    // A change of rank two takes two steps more; the residual is the true one
    matrix near = s.A;
    near(1, 4) += 2;
    near(6, 0) -= 1.5;
    EXPECT_EQ(s.solve(near, inverse, 1e-11, n, x, s.b), 3);
    EXPECT_LT((near*x - s.b).norm(), 1e-11*s.b.norm());
}


//- A right-hand side that is an eigenvector leaves nothing for a second one
TEST(gmres, survivesTheEndOfItsSpace)
{
    smallSystem s;
    matrix D = matrix::Identity(n, n);
    D(2, 2) = 5;
    column x;
    EXPECT_EQ(s.solve(D, matrix::Identity(n, n), 0, n, x, column::Unit(n, 2)), 1);
    EXPECT_LT((5*x - column::Unit(n, 2)).norm(), 1e-15);
}


//- One that is used again is as a new one
TEST(gmres, isUsedAgain)
{
    smallSystem s;
    gmres solver(s.map, n);
    EXPECT_EQ(solver.maxIter(), n);
    const auto identity = [](const scalarField& x, scalarField& y) { y = x; };
    scalarField x(s.map.nUnknowns()), first;
    for (const scalar factor : {1.0, -3.0, 1.0})
    {
        const label k = solver.solve
        (
            [&](const scalarField& x, scalarField& y) { y = s.field(factor*s.A*s.dense(x)); },
            identity, s.field(s.b), x, 1e-12, n
        );
        EXPECT_EQ(k, n);
        EXPECT_LT((factor*s.A*s.dense(x) - s.b).norm(), 1e-12*s.b.norm());
        if (first.empty()) first = x;
    }
    EXPECT_TRUE(x == first);
}


//- What is no number ends it, and is handed on
TEST(gmres, endsWhereThereAreNoNumbers)
{
    const trapsOff guard;
    smallSystem s;
    matrix bad = s.A;
    bad(3, 3) = std::numeric_limits<scalar>::quiet_NaN();
    column x;
    EXPECT_EQ(s.solve(bad, matrix::Identity(n, n), 1e-12, n, x, s.b), 1);
    EXPECT_FALSE(x.allFinite());
}


//- Residuals after fixed-point iterations with M = 6 for A
static List<scalar> fixedPoint(const smallSystem& s, const label most, const bool accelerated)
{
    andersonSteps steps(s.map);
    column x = column::Zero(n);
    scalarField dx(s.map.nUnknowns(), 0);
    const scalarField W(s.map.nUnknowns(), 2);
    List<scalar> norms;
    for (label k = 0; k <= most; ++k)
    {
        const column R = s.A*x - s.b;
        norms.append(R.norm()/s.b.norm());
        if (!accelerated) steps.clear();
        steps.next(s.field(R), s.field(-R/6), W, dx);
        x += s.dense(dx);
    }
    return norms;
}


TEST(andersonSteps, solveALinearProblemInAsManyStepsAsUnknowns)
{
    const smallSystem s;
    const List<scalar> norms(fixedPoint(s, n + 1, true));
    EXPECT_LT(norms[n + 1], 1e-9);
    EXPECT_GT(fixedPoint(s, n + 1, false).last(), 1e-3);
}


TEST(andersonSteps, oneIterationIsThatOfTheFixedPoint)
{
    const smallSystem s;
    EXPECT_DOUBLE_EQ(fixedPoint(s, 1, true)[1], fixedPoint(s, 1, false)[1]);
}


// ************************************************************************* //
