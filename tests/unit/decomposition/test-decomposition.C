/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-decomposition

Description
    Tests of src/decomposition: METIS on graphs of quadrilaterals, and the
    selection of the method.
\*---------------------------------------------------------------------------*/

#include "runOnRanks.H"
#include "partition.H"
#include "decompositionMethod.H"
#include "IStringStream.H"
#include "DynamicList.H"
#include "boolList.H"

using namespace Foam;

namespace
{

//- n x m cells, the rows apart or not
struct grid
{
    label n, m;
    labelListList neighbours;
    labelList start, neighbour;

    grid(const label n, const label m, const bool rowsApart = false)
    :
        n(n), m(m), neighbours(n*m), start(1, label(0))
    {
        for (label j = 0; j < m; ++j) for (label i = 0; i < n; ++i)
        {
            labelList& c = neighbours[j*n + i];
            if (i > 0) c.append(j*n + i - 1);
            if (i < n - 1) c.append(j*n + i + 1);
            if (j > 0 && !rowsApart) c.append((j - 1)*n + i);
            if (j < m - 1 && !rowsApart) c.append((j + 1)*n + i);
            neighbour.append(c);
            start.append(neighbour.size());
        }
    }

    //- Number of connected pieces of a part
    label nPieces(const labelList& part, const label p) const
    {
        boolList met(part.size(), false);
        label nFound = 0;
        forAll(part, first)
        {
            if (met[first] || part[first] != p) continue;
            ++nFound;
            DynamicList<label> front(1, first);
            while (front.size())
            {
                const label c = front.remove();
                met[c] = true;
                for (const label d : neighbours[c]) if (!met[d] && part[d] == p) front.append(d);
            }
        }
        return nFound;
    }
};


//- Weight of each part over the weight of all
scalarList shares(const labelList& part, const scalarList& weight, const label nParts)
{
    scalarList share(nParts, scalar(0));
    scalar total = 0;
    for (const scalar w : weight) total += w;
    forAll(part, i) share[part[i]] += weight[i]/total;
    return share;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(partition, partsAreConnectedAndBalanced)
{
    const grid g(24, 20);
    const scalarList ones(g.n*g.m, scalar(1));
    for (const label nParts : {1, 2, 3, 4, 7, 16})
    {
        const labelList part(partition(g.start, g.neighbour, ones, nParts, scalarList()));
        const scalarList share(shares(part, ones, nParts));
        for (label p = 0; p < nParts; ++p)
        {
            EXPECT_EQ(g.nPieces(part, p), 1) << "part " << p << " of " << nParts;
            EXPECT_NEAR(share[p]*nParts, 1, 0.1);
        }
        EXPECT_EQ(part, partition(g.start, g.neighbour, ones, nParts, scalarList()));
    }
}


TEST(partition, weightsAndSharesCount)
{
    const grid g(24, 20);
    scalarList weight(g.n*g.m);
    forAll(weight, i) weight[i] = i % g.n < 6 ? 5e-7 : 1e-7;
    const scalarList wanted({0.5, 0.3, 0.2});
    const labelList part(partition(g.start, g.neighbour, weight, 3, wanted));
    const scalarList share(shares(part, weight, 3));
    forAll(wanted, p) EXPECT_NEAR(share[p], wanted[p], 0.05);
}


TEST(partition, graphsInPiecesAndSmallOnesHaveNoEmptyPart)
{
    const grid rows(8, 6, true);
    const scalarList ones(rows.n*rows.m, scalar(1));
    for (const label n : partSizes(partition(rows.start, rows.neighbour, ones, 5, scalarList()), 5)) EXPECT_GT(n, 0);

    const grid small(3, 2);
    const scalarList six(6, scalar(1));
    for (const label n : partSizes(partition(small.start, small.neighbour, six, 4, scalarList()), 4)) EXPECT_GT(n, 0);
}


TEST(metis, isOursAndObeysItsDictionary)
{
    const grid g(12, 10);
    const dictionary dict
    (
        IStringStream("numberOfSubdomains 3; method metis; metisCoeffs { processorWeights (2 1 1); }")()
    );
    const labelList part
    (
        decompositionMethod::New(dict)->decompose(g.neighbours, pointField(g.n*g.m, Zero))
    );
    const scalarList share(shares(part, scalarList(part.size(), scalar(1)), 3));
    EXPECT_NEAR(share[0], 0.5, 0.05);
    EXPECT_NEAR(share[1], 0.25, 0.05);
}


int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //
