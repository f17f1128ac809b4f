/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of regionState.
\*---------------------------------------------------------------------------*/

#include "complaint.H"
#include "regionState.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "Random.H"
#include <gtest/gtest.h>
#include <limits>

using namespace Foam;

namespace
{

//- Motion and velocity at some nodes, pressure at some vertices, a history
//  variable in some cells, and a part without values
struct exampleState
{
    motionField D;
    rateField<vector> v;
    rateField<scalar> p, history, none;
    regionState state;

    exampleState(const label nNodes, const label nVertices, const label nCells, const label seed = 0)
    :
        D(nNodes),
        v(nNodes),
        p(nVertices),
        history(nCells)
    {
        typedef fieldLayout::support on;
        state.add("D", on::NODES, D);
        state.add("v", on::NODES, v);
        state.add("p", on::VERTICES, p);
        state.add("history", on::CELLS, history);
        state.add("none", on::NODES, none);
        if (seed) randomise(seed);
    }

    void randomise(const label seed)
    {
        Foam::Random random(seed);
        scalarList all(state.copy());
        for (scalar& s : all) s = random.GaussNormal<scalar>();
        state.set(all);
    }

    bool isShifted() const
    {
        return
            D.D0 == D.D && D.v0 == D.v && D.a0 == D.a && v.v0 == v.v && v.a0 == v.a
         && p.v0 == p.v && p.a0 == p.a && history.v0 == history.v && history.a0 == history.a;
    }
};


} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(regionState, theEndOfAStepIsTheStartOfTheNext)
{
    exampleState s(5, 3, 2, 1);
    const vectorField D(s.D.D), a(s.v.a);
    const scalarField rate(s.p.a);
    EXPECT_FALSE(s.isShifted());
    s.state.shift();
    EXPECT_TRUE(s.isShifted());
    EXPECT_TRUE(s.D.D == D && s.v.a == a && s.p.a == rate);
}


TEST(regionState, isCopiedAndSetToTheBit)
{
    exampleState s(5, 3, 2, 1);
    const scalarList before(s.state.copy());

    // Three levels of vectors, two of vectors, two of scalars; now and before
    EXPECT_EQ(before.size(), 2*(3*3*5 + 2*3*5 + 2*3 + 2*2));
    const vectorField D0(s.D.D0), D(s.D.D), a0(s.v.a0);
    const scalarField p(s.p.v);
    s.randomise(2);
    EXPECT_FALSE(s.D.D0 == D0);
    s.state.set(before);
    EXPECT_TRUE(s.D.D0 == D0 && s.D.D == D && s.v.a0 == a0 && s.p.v == p);
    EXPECT_TRUE(s.state.copy() == before);

    // Not a list of values that happen to be equal
    scalarList odd(before);
    odd[7] = -0.0;
    odd[8] = std::numeric_limits<scalar>::denorm_min();
    s.state.set(odd);
    const scalarList again(s.state.copy());
    EXPECT_TRUE(std::signbit(again[7]));
    EXPECT_EQ(again[8], odd[8]);
}


TEST(regionState, isFoundByName)
{
    exampleState s(5, 3, 2, 1);
    EXPECT_EQ(s.state.find<vector>("D"), &s.D.D);
    EXPECT_EQ(s.state.find<vector>("DVelocity"), &s.D.v);
    EXPECT_EQ(s.state.find<vector>("DAcceleration"), &s.D.a);
    EXPECT_EQ(s.state.find<vector>("vRate"), &s.v.a);
    EXPECT_EQ(s.state.find<scalar>("p"), &s.p.v);
    EXPECT_EQ(s.state.find<scalar>("pRate"), &s.p.a);
    EXPECT_EQ(s.state.find<scalar>("D"), nullptr);
    EXPECT_EQ(s.state.find<vector>("p"), nullptr);
}


TEST(regionState, isMappedWithWeights)
{
    exampleState s(5, 3, 2, 1);
    const exampleState old(5, 3, 2, 1);

    // To one node more, the same number of vertices, no cells
    stateMap map;
    map.nodes.from = List<labelList>({{4}, {0, 1}, {1, 2, 3}, {2}, {0}, {}});
    map.nodes.weight = List<scalarList>({{1}, {0.25, 0.75}, {0.5, -1, 2}, {3}, {1}, {}});
    map.vertices.from = List<labelList>({{2}, {0, 1}, {1}});
    map.vertices.weight = List<scalarList>({{1}, {0.5, 0.5}, {-2}});
    s.state.map(map);

    EXPECT_EQ(s.D.size(), 6);
    EXPECT_EQ(s.p.size(), 3);
    EXPECT_EQ(s.history.size(), 0);
    EXPECT_EQ(s.none.size(), 0);
    const auto expectMapped = [&](const auto& now, const auto& before, const valueMap& m)
    {
        ASSERT_EQ(now.size(), m.from.size());
        forAll(now, i)
        {
            typename std::decay<decltype(now[i])>::type value = Zero;
            forAll(m.from[i], k) value += m.weight[i][k]*before[m.from[i][k]];
            EXPECT_LT(mag(now[i] - value), 1e-15) << i;
        }
    };
    for (const auto level : {&motionField::D, &motionField::v, &motionField::a, &motionField::D0, &motionField::v0, &motionField::a0})
    {
        expectMapped(s.D.*level, old.D.*level, map.nodes);
    }
    for (const auto level : {&rateField<vector>::v, &rateField<vector>::a, &rateField<vector>::v0, &rateField<vector>::a0})
    {
        expectMapped(s.v.*level, old.v.*level, map.nodes);
    }
    for (const auto level : {&rateField<scalar>::v, &rateField<scalar>::a, &rateField<scalar>::v0, &rateField<scalar>::a0})
    {
        expectMapped(s.p.*level, old.p.*level, map.vertices);
    }
}


//- The end of a step; a restart shifts it
TEST(regionState, isWrittenAndRead)
{
    exampleState s(5, 3, 2, 1), read(5, 3, 2, 2);
    OStringStream os(IOstream::BINARY);
    s.state.write(os);
    IStringStream is(os.str(), IOstream::BINARY);
    read.state.read(is);
    EXPECT_FALSE(read.state.copy() == s.state.copy());
    s.state.shift();
    read.state.shift();
    EXPECT_TRUE(read.state.copy() == s.state.copy());
}


TEST(regionState, complainsOfOtherFiles)
{
    exampleState s(5, 3, 2, 1);
    OStringStream os(IOstream::BINARY);
    s.state.write(os);
    const auto read = [&](exampleState& to, const std::string& text)
    {
        return complaint([&]() { IStringStream is(text, IOstream::BINARY); to.state.read(is); });
    };
    exampleState fewer(4, 3, 2);
    EXPECT_NE(read(fewer, os.str()).find("expected 'D' with 4"), std::string::npos);

    std::string renamed(os.str());
    renamed.replace(renamed.find("DVelocity"), 9, "DPosition");
    EXPECT_NE(read(s, renamed).find("expected 'DVelocity'"), std::string::npos);

    exampleState bad(5, 3, 2, 3);
    bad.p.a[1] = std::numeric_limits<scalar>::quiet_NaN();
    OStringStream broken(IOstream::BINARY);
    bad.state.write(broken);
    EXPECT_NE(read(s, broken.str()).find("'pRate' has values that are not finite"), std::string::npos);
}


// ************************************************************************* //
