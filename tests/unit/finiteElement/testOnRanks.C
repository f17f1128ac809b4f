/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the numbering of nodes and of decomposed meshes: on one rank or
    more.
\*---------------------------------------------------------------------------*/

#include "feMesh.H"
#include "nodeMap.H"
#include "Time.H"
#include "Random.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "ListListOps.H"
#include <gtest/gtest.h>
#include <map>
#include <cstdlib>

using namespace Foam;

namespace
{

template<class T>
List<T> gathered(const UList<T>& mine)
{
    List<List<T>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    return ListListOps::combine<List<T>>(all, accessOp<List<T>>());
}

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

//- Case of the script fsiPatch on the ranks of this run
struct decomposedCase
{
    fileName dir;
    autoPtr<Time> time;
    autoPtr<polyMesh> mesh;

    explicit decomposedCase(const label dim)
    {
        std::string name = "/tmp/test-finiteElement-XXXXXX";
        if (Pstream::master())
        {
            dir = ::mkdtemp(&name[0]);
            const std::string make = getEnv("MONOLITHICFOAM_DIR") + "/tests/resources/fsiPatch " + dir
                + " nx=4 ny=3 dim=" + std::to_string(dim) + " ranks=" + std::to_string(Pstream::nProcs());
            if (std::system(make.c_str())) FatalErrorInFunction << make.c_str() << exit(FatalError);
        }
        Pstream::scatter(dir);
        fileName caseName(dir.name());
        if (Pstream::parRun()) caseName = caseName/("processor" + Foam::name(Pstream::myProcNo()));
        time.reset(new Time(Time::controlDictName, fileName(dir.path()), caseName));
        mesh.reset(new polyMesh(IOobject("fluid", time->constant(), time(), IOobject::MUST_READ)));
    }

    ~decomposedCase()
    {
        mesh.clear();
        time.clear();
        label done = 1;
        reduce(done, sumOp<label>());
        if (Pstream::master()) rmDir(dir);
    }
};

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
    keys = gathered(keys);
    numbers = gathered(numbers);
    owners = gathered(owners);
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
    for (const label k : gathered(key)) ++copies[k];

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
        keys = gathered(keys);
        const scalarField all(gathered(x));
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
        const decomposedCase c(dim);
        for (const label order : {1, 2})
        {
            SCOPED_TRACE(std::to_string(dim) + "-D, order " + std::to_string(order));
            const feMesh fe(c.mesh(), order, dictionary());
            const nodeMap map(fe.key(), labelList(fe.nNodes(), 1));

            const label n = 4*order + 1, m = 3*order + 1, depth = dim == 2 ? 1 : 2*order + 1;
            EXPECT_EQ(map.numbering().size(), n*m*depth);
            EXPECT_EQ(returnReduce(fe.nElements(), sumOp<label>()), 12*(dim - 1));

            const vectorField X(gathered(fe.points()));
            const labelList keys(gathered(fe.key()));
            forAll(X, i) forAll(X, j)
            {
                EXPECT_EQ(mag(X[i] - X[j]) < 1e-10, keys[i] == keys[j]) << X[i].x() << ' ' << X[j].x();
            }
            EXPECT_EQ(map.numbering().localSize() > 0, true);

            // Every patch's nodes, counted once, are those of one rank
            const label patchi = c.mesh->boundaryMesh().findPatchID("wet");
            labelHashSet wet;
            for (const label k : gathered(labelList(UIndirectList<label>(fe.key(), fe.patchNodes(patchi))())))
            {
                wet.insert(k);
            }
            EXPECT_EQ(wet.size(), n*depth);
        }
    }
}


// ************************************************************************* //
