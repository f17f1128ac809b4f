/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "matchingInterface.H"
#include "addToRunTimeSelectionTable.H"
#include "gatherAll.H"
#include "unknownEntries.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(matchingInterface, 0);
    addToRunTimeSelectionTable(feInterface, matchingInterface, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Present positions, of mid-side nodes the means of their ends
static vectorField straightSided(const feRegion& region)
{
    const feMesh& fe = region.fe();
    vectorField x(fe.points() + region.motion().D);
    for (label n = fe.nVertices(); n < x.size(); ++n)
    {
        x[n] = Zero;
        for (const label m : fe.parents()[n]) x[n] += x[m]/scalar(fe.parents()[n].size());
    }
    return x;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::matchingInterface::fail
(
    const UList<scalar>& gaps,
    const UList<point>& places
) const
{
    if (gaps.empty()) return;
    label worst = 0;
    forAll(gaps, i) if (gaps[i] > gaps[worst]) worst = i;
    FatalIOErrorInFunction(dict())
        << "Interface " << name() << " does not match: " << gaps.size()
        << " nodes of patch " << fluid().mesh().boundaryMesh()[followerPatches()[0]].name()
        << " (region " << fluid().name() << ") and patch "
        << solid().mesh().boundaryMesh()[leaderPatches()[0]].name()
        << " (region " << solid().name() << ") have no partner." << nl
        << "Largest gap " << gaps[worst] << " m at " << places[worst] << '.' << nl
        << "Both meshes need the same points on the interface, and elements of"
        << " the same order." << exit(FatalIOError);
}


template<class F, class G>
void Foam::matchingInterface::handOver(const F& f, const G& put) const
{
    const fieldUnknowns &from = solid().unknowns(), &to = fluid().unknowns();
    scalarField y(from.map().nUnknowns(), 0);
    const labelList nodes(leaderNodes());
    forAll(nodes, i)
    {
        if (!speaks_[i]) continue;
        const vector value(f(nodes[i]));
        from.forCmpts(0, nodes[i], [&](const label c, const label u) { y[u] = value[c]; });
    }
    from.map().sum(y);
    const labelList followers(followerNodes());
    forAll(followers, i) put(i, followers[i], to.at(0, followers[i], y));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::matchingInterface::matchingInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    fsiInterface(name, dict, regions)
{
    reportUnknownEntries(dict, {"type", "fluid", "solid", "tolerance"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::matchingInterface::pairing Foam::matchingInterface::pairs
(
    const vectorField& solidPoints,
    const labelUList& solidKey,
    const vectorField& fluidPoints,
    const labelUList& fluidKey
) const
{
    const labelList fluidN(followerNodes()), solidN(leaderNodes());

    // In 2-D the meshes may lie at different depths
    const label depth = fluid().fe().dim() == 2 ? fluid().fe().axis(2) : -1;
    const auto flat = [&](point p) { if (depth >= 0) p[depth] = 0; return p; };

    pointField all(gatherAll<point>(pointField(solidPoints, solidN)));
    for (point& p : all) p = flat(p);
    const labelList allKeys(gatherAll<label>(labelList(UIndirectList<label>(solidKey, solidN))));

    treeBoundBox bb(all);
    const scalar tolerance = dict().lookupOrDefault<scalar>("tolerance", 1e-6)*bb.mag();
    bb.inflate(0.01);
    bb.min() -= vector::uniform(SMALL + 1e-3*bb.mag());
    bb.max() += vector::uniform(SMALL + 1e-3*bb.mag());
    const indexedOctree<treeDataPoint> tree(treeDataPoint(all), bb, 10, 10, 3);

    pairing p;
    for (const label n : fluidN)
    {
        const point X = flat(fluidPoints[n]);
        const pointIndexHit hit = tree.findNearest(X, sqr(GREAT));
        const scalar gap = hit.hit() ? mag(X - hit.hitPoint()) : GREAT;
        if (gap <= tolerance)
        {
            p.keys.append(labelPair(allKeys[hit.index()], fluidKey[n]));
            continue;
        }
        p.gaps.append(gap);
        p.places.append(fluidPoints[n]);
    }
    p.keys = gatherAll<labelPair>(p.keys);

    // Solid nodes that no fluid node of any rank has met
    labelHashSet met;
    for (const labelPair& pair : p.keys) met.insert(pair.first());
    for (const label n : solidN)
    {
        if (met.found(solidKey[n])) continue;
        p.gaps.append(0);
        p.places.append(solidPoints[n]);
    }
    p.gaps = gatherAll<scalar>(p.gaps);
    p.places = gatherAll<point>(p.places);
    return p;
}


Foam::List<Foam::labelPair> Foam::matchingInterface::joined
(
    const labelUList& solidKey,
    const labelUList& fluidKey
) const
{
    // The two have one reference, or the fluid's mesh is younger: then they meet
    // where they are now
    const feMesh &fluidMesh = fluid().fe(), &solidMesh = solid().fe();
    const pairing first(pairs(solidMesh.points(), solidKey, fluidMesh.points(), fluidKey));
    if (!first.gaps.empty())
    {
        const pairing now(pairs(straightSided(solid()), solidKey, straightSided(fluid()), fluidKey));
        if (now.gaps.empty())
        {
            checkFree();
            return now.keys;
        }
    }
    fail(first.gaps, first.places);
    checkFree();
    return first.keys;
}


void Foam::matchingInterface::constrain(dofConstraints&)
{
    // The lowest rank that has a solid node
    const fieldUnknowns& from = solid().unknowns();
    const labelList nodes(leaderNodes());
    scalarField rank(from.map().nUnknowns(), -GREAT);
    for (const label n : nodes) rank[from.start(0, n)] = -Pstream::myProcNo();
    from.map().maximum(rank);
    speaks_.setSize(nodes.size());
    forAll(nodes, i) speaks_[i] = rank[from.start(0, nodes[i])] == -Pstream::myProcNo();

    const vectorField &Xs = solid().fe().points(), &Xf = fluid().fe().points();
    offset_ = vectorField(followerNodes().size(), Zero);
    handOver
    (
        [&](const label n) { return Xs[n]; },
        [&](const label i, const label n, const vector& X)
        {
            for (label a = 0; a < fluid().fe().dim(); ++a)
            {
                const label c = fluid().fe().axis(a);
                offset_[i][c] = X[c] - Xf[n][c];
            }
        }
    );
}


void Foam::matchingInterface::follow()
{
    const motionField& s = static_cast<const feRegion&>(solid()).motion();
    motionField& f = fluid().motion();

    // x = X_s + D_s = X_f + D_f, without the round-off of the sums
    handOver
    (
        [&](const label n) { return s.D[n]; },
        [&](const label i, const label n, const vector& D) { f.D[n] = D + offset_[i]; }
    );
    handOver
    (
        [&](const label n) { return s.v[n]; },
        [&](const label, const label n, const vector& v) { f.v[n] = v; }
    );
    handOver
    (
        [&](const label n) { return s.a[n]; },
        [&](const label, const label n, const vector& a) { f.a[n] = a; }
    );
}


// ************************************************************************* //
