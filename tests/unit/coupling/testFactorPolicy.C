/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of factorPolicy.
\*---------------------------------------------------------------------------*/

#include "tangentSolver.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Factors of some entries that cost as much as some back-substitutions
factorPolicy made(const scalar making, const scalar nNonzeros = 1000)
{
    factorPolicy p;
    p.made(20*making*nNonzeros, nNonzeros);
    return p;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(factorPolicy, beginsWithoutFactors)
{
    EXPECT_FALSE(factorPolicy().has);
}


TEST(factorPolicy, countsInBackSubstitutions)
{
    for (const scalar nNonzeros : {1.0, 1e3, 1e9})
    {
        const factorPolicy p = made(30, nNonzeros);
        EXPECT_TRUE(p.has);
        EXPECT_NEAR(p.making, 30, 1e-12);
        EXPECT_EQ(p.total, p.making);
        EXPECT_EQ(p.uses, 0);
    }

    // A rank may have none
    factorPolicy none;
    none.made(0, 0);
    EXPECT_TRUE(none.has);
    EXPECT_EQ(none.making, 0);
}


//- With the cost of making them, 100
TEST(factorPolicy, isRenewedWhenASolutionCostsMoreThanTheAverage)
{
    factorPolicy p = made(100);
    for (const label n : {5, 5, 5, 31})
    {
        p.used(n);
        EXPECT_TRUE(p.has) << n;
    }
    EXPECT_NEAR(p.total, 146, 1e-12);
    EXPECT_EQ(p.uses, 4);
    factorPolicy less(p);
    less.used(36);
    EXPECT_TRUE(less.has);      // (146 + 36)/5 = 36.4
    p.used(37);
    EXPECT_FALSE(p.has);        // (146 + 37)/5 = 36.6

    // New factors count anew
    p.made(20*100*1000, 1000);
    EXPECT_TRUE(p.has);
    EXPECT_NEAR(p.total, 100, 1e-12);
    EXPECT_EQ(p.uses, 0);
}


//- However much it costs: there is nothing to compare it with
TEST(factorPolicy, keepsNewFactorsAfterTheFirstSolution)
{
    factorPolicy p = made(1);
    p.used(60);
    EXPECT_TRUE(p.has);

    // Cheap factors go as soon as the iterations rise
    factorPolicy cheap = made(0);
    cheap.used(4);
    cheap.used(4);
    EXPECT_TRUE(cheap.has);
    cheap.used(5);
    EXPECT_FALSE(cheap.has);
}


TEST(factorPolicy, limitsTheIterationsByTheCostOfNewFactors)
{
    EXPECT_EQ(made(0).limit(60), 10);
    EXPECT_EQ(made(7.9).limit(60), 17);
    EXPECT_EQ(made(50).limit(60), 60);
    EXPECT_EQ(made(1e9).limit(60), 60);
    EXPECT_EQ(made(7.9).limit(5), 5);
}


// ************************************************************************* //
