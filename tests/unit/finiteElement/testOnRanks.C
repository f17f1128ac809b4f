/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the numbering of nodes and of decomposed meshes: on one rank or
    more.
\*---------------------------------------------------------------------------*/

#include "decomposedCase.H"
#include "feMesh.H"
#include "nodeMap.H"
#include "gatherAll.H"
#include "Random.H"
#include "IStringStream.H"
#include <gtest/gtest.h>
#include <map>

using namespace Foam;

namespace
{

//- Eight nodes a rank, of which the next one has three, too, and one of all
labelList chain()
{
    labelList key(identity(8));
    for (label& k : key) k += 5*Pstream::myProcNo();
    key.append(10000);
    return key;
}

labelList counts(const labelList& key)
{
    labelList n(key.size());
    forAll(key, i) n[i] = 2 + key[i]%2;

    // One rank knows more of the common node than the others
    n.last() = Pstream::myProcNo() == Pstream::nProcs() - 1 ? 4 : 1;
    return n;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nodeMap, numbersAreContiguousAndOfOneNodeOne)
{
    const labelList key(chain());
    const nodeMap map(key, counts(key));

    // Owned unknowns have the rank's numbers in turn; sizes agree
    forAll(map.ownedUnknowns(), i)
    {
        EXPECT_EQ(map.global(map.ownedUnknowns()[i]), map.numbering().toGlobal(i));
    }
    EXPECT_EQ(map.numbering().localSize(), map.ownedUnknowns().size());
    EXPECT_EQ(map.nUnknowns(key.size() - 1), 4);

    // The number of a node's unknown by its key, of all ranks
    labelList keys, numbers, owners;
    forAll(key, i) for (label c = 0; c < map.nUnknowns(i); ++c)
    {
        keys.append(10*key[i] + c);
        numbers.append(map.global(map.start(i) + c));
        if (map.owned(i)) owners.append(10*key[i] + c);
        EXPECT_EQ(map.global(map.start(i) + c), map.global(map.start(i)) + c);
    }
    keys = gatherAll<label>(keys);
    numbers = gatherAll<label>(numbers);
    owners = gatherAll<label>(owners);
    std::map<label, label> numberOf, keyOf;
    forAll(keys, i)
    {
        EXPECT_EQ(numberOf.emplace(keys[i], numbers[i]).first->second, numbers[i]);
        EXPECT_EQ(keyOf.emplace(numbers[i], keys[i]).first->second, keys[i]);
    }
    EXPECT_EQ(label(numberOf.size()), map.numbering().size());
    EXPECT_EQ(owners.size(), map.numbering().size());
    EXPECT_EQ(keyOf.begin()->first, 0);
    EXPECT_EQ(keyOf.rbegin()->first, map.numbering().size() - 1);
}


TEST(nodeMap, sumCountsCopies)
{
    const labelList key(chain());
    const nodeMap map(key, counts(key));
    std::map<label, label> copies;
    for (const label k : gatherAll<label>(key)) ++copies[k];

    scalarField x(map.nUnknowns(), 1);
    map.sum(x);
    forAll(key, i) for (label u = map.start(i); u < map.start(i + 1); ++u)
    {
        EXPECT_EQ(x[u], copies[key[i]]);
    }
    EXPECT_EQ(copies[10000], Pstream::nProcs());

    // Each unknown once
    scalarField one(map.nUnknowns(), 1);
    EXPECT_EQ(map.dot(one, one), map.numbering().size());
}


TEST(nodeMap, copiesAgreeToTheBit)
{
    const labelList key(chain());
    const nodeMap map(key, counts(key));
    Foam::Random random(17 + Pstream::myProcNo());
    scalarField mine(map.nUnknowns());
    for (scalar& s : mine) s = random.GaussNormal<scalar>();

    const auto expectAgreement = [&](const scalarField& x)
    {
        labelList keys;
        forAll(key, i) for (label c = 0; c < map.nUnknowns(i); ++c) keys.append(10*key[i] + c);
        keys = gatherAll<label>(keys);
        const scalarField all(gatherAll<scalar>(x));
        std::map<label, scalar> valueOf;
        forAll(keys, i) EXPECT_EQ(valueOf.emplace(keys[i], all[i]).first->second, all[i]);
    };
    scalarField sum(mine), owner(mine), largest(mine);
    map.sum(sum);
    map.fromOwner(owner);
    map.maximum(largest);
    expectAgreement(sum);
    expectAgreement(owner);
    expectAgreement(largest);
    forAll(mine, u) EXPECT_GE(largest[u], mine[u]);
    for (const label u : map.ownedUnknowns()) EXPECT_EQ(owner[u], mine[u]);

    // The sum is the sum: over all copies of the additive values
    scalar total = 0, consistent = 0;
    for (const scalar s : mine) total += s;
    for (const label u : map.ownedUnknowns()) consistent += sum[u];
    reduce(total, sumOp<scalar>());
    reduce(consistent, sumOp<scalar>());
    EXPECT_NEAR(total, consistent, 1e-13);
}


TEST(decomposed, aPlaceHasOneKey)
{
    for (const label dim : {2, 3})
    {
        const decomposedCase c
        (
            "fsiPatch",
            "nx=4 ny=3 dim=" + std::to_string(dim) + " ranks=" + std::to_string(Pstream::nProcs())
        );
        for (const label order : {1, 2})
        {
            SCOPED_TRACE(std::to_string(dim) + "-D, order " + std::to_string(order));
            const feMesh fe(c.mesh(), order, dictionary());
            const nodeMap map(fe.key(), labelList(fe.nNodes(), 1));

            const label n = 4*order + 1, m = 3*order + 1, depth = dim == 2 ? 1 : 2*order + 1;
            EXPECT_EQ(map.numbering().size(), n*m*depth);
            EXPECT_EQ(returnReduce(fe.nElements(), sumOp<label>()), 12*(dim - 1));

            const vectorField X(gatherAll<vector>(fe.points()));
            const labelList keys(gatherAll<label>(fe.key()));
            forAll(X, i) forAll(X, j)
            {
                EXPECT_EQ(mag(X[i] - X[j]) < 1e-10, keys[i] == keys[j]) << X[i].x() << ' ' << X[j].x();
            }
            EXPECT_EQ(map.numbering().localSize() > 0, true);

            // Every patch's nodes, counted once, are those of one rank
            const label patchi = c.mesh->boundaryMesh().findPatchID("wet");
            labelHashSet wet;
            for (const label k : gatherAll<label>(labelList(UIndirectList<label>(fe.key(), fe.patchNodes(patchi))())))
            {
                wet.insert(k);
            }
            EXPECT_EQ(wet.size(), n*depth);
        }
    }
}


TEST(decomposed, patchNodesAreComplete)
{
    for (const std::string kind : {"tri", "quad", "tet", "hex"})
    {
        const std::string ranks = std::to_string(Pstream::nProcs());
        const decomposedCase c("scatteredBox", kind + " 4 " + ranks + " cyclic");
        for (const label order : {1, 2})
        {
            SCOPED_TRACE(kind + ", order " + std::to_string(order));
            const feMesh fe(c.mesh(), order, dictionary());

            // Nodes opposite to each other on cyclic patches are two
            const label n = 4*order + 1;
            EXPECT_EQ(fe.copies().numbering().size(), fe.dim() == 2 ? n*n : n*n*n);

            label nTouchedOnly = 0;
            const char* names[] = {"left", "right", "bottom", "top"};
            for (label side = 0; side < 4; ++side)
            {
                const label patchi = c.mesh->boundaryMesh().findPatchID(names[side]);
                labelList expected;
                forAll(fe.points(), i)
                {
                    if (mag(fe.points()[i][side/2] - side%2) < 1e-10) expected.append(i);
                }
                EXPECT_EQ(fe.patchNodes(patchi), expected) << names[side];

                labelHashSet onFaces;
                for (const elementBlock& block : fe.patchBlocks(patchi)) onFaces.insert(block.nodes);
                nTouchedOnly += expected.size() - onFaces.size();
            }
            reduce(nTouchedOnly, sumOp<label>());
            const bool simplices = kind[0] == 't';
            EXPECT_EQ(nTouchedOnly > 0, simplices && Pstream::parRun());
        }
    }
}


TEST(decomposed, curvedPatchesAreThoseOfOneRank)
{
    // The surface turns the left side's mid-side nodes inwards, also those of
    // ranks that have no face there
    const decomposedCase c("scatteredBox", "tri 4 " + std::to_string(Pstream::nProcs()));
    const dictionary dict
    (
        IStringStream
        (
            "curvedPatches { left { type searchableSphere; centre (-10 0.5 0.5); radius 10.01; } }"
        )()
    );
    const feMesh fe(c.mesh(), 2, dict), straight(c.mesh(), 2, dictionary());
    forAll(fe.points(), n)
    {
        const point& X = straight.points()[n];
        const bool curved = mag(X.x()) < 1e-10 && n >= fe.nVertices();
        EXPECT_EQ(mag(fe.points()[n] - X) > 1e-6, curved) << n;
    }
}


// ************************************************************************* //
