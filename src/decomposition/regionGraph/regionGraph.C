/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionGraph.H"
#include "Time.H"
#include "IOdictionary.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "SubField.H"
#include "wordRes.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::UPtrList<const Foam::dictionary> Foam::regionGraph::sides
(
    const dictionary& interface
)
{
    UPtrList<const dictionary> found;
    for (const entry& e : interface)
    {
        if (e.isDict() && e.dict().found("region")) found.append(&e.dict());
    }
    if (found.size() != 2)
    {
        FatalIOErrorInFunction(interface)
            << "Interface " << interface.dictName() << " has " << found.size()
            << " sub-dictionaries with an entry 'region', expected 2"
            << exit(FatalIOError);
    }
    return found;
}


Foam::labelList Foam::regionGraph::patches
(
    const dictionary& side,
    const polyMesh& mesh
)
{
    wordRes names;
    if (!side.readIfPresent("patches", names)) names = wordRes(1, side.get<wordRe>("patch"));

    const polyBoundaryMesh& boundary = mesh.boundaryMesh();
    const labelList found(boundary.patchSet(names).sortedToc());
    if (found.empty())
    {
        FatalIOErrorInFunction(side)
            << "Region " << mesh.name() << " has no patch " << names
            << ". Its patches are " << boundary.names() << exit(FatalIOError);
    }
    return found;
}


Foam::label Foam::regionGraph::index(const word& region) const
{
    return std::lower_bound(regions_.begin(), regions_.end(), region) - regions_.begin();
}


void Foam::regionGraph::findRegions
(
    const dictionary& interfaces,
    const word& region
)
{
    wordHashSet joined({region});
    for (label n = 0; n != joined.size();)
    {
        n = joined.size();
        for (const entry& e : interfaces)
        {
            const auto s = sides(e.dict());
            const word a(s[0].get<word>("region")), b(s[1].get<word>("region"));
            if (joined.found(a) || joined.found(b)) joined.insert({a, b});
        }
    }
    regions_ = joined.sortedToc();
}


Foam::List<Foam::labelPair> Foam::regionGraph::pairs
(
    const dictionary& interface,
    const UPtrList<const polyMesh>& meshes,
    const labelList& firstCell
) const
{
    pointField centres[2];
    labelList cells[2];
    const auto s = sides(interface);
    for (label i = 0; i < 2; ++i)
    {
        const label r = index(s[i].get<word>("region"));
        for (const label patchi : patches(s[i], meshes[r]))
        {
            const polyPatch& pp = meshes[r].boundaryMesh()[patchi];
            centres[i].append(pp.faceCentres());
            for (const label celli : pp.faceCells()) cells[i].append(firstCell[r] + celli);
        }
    }
    const label fine = centres[1].size() > centres[0].size(), coarse = 1 - fine;
    if (centres[coarse].empty()) return List<labelPair>();

    treeBoundBox bb(centres[coarse]);
    bb.inflate(0.01);
    bb.min() -= point::uniform(ROOTVSMALL);
    bb.max() += point::uniform(ROOTVSMALL);
    const indexedOctree<treeDataPoint> tree(treeDataPoint(centres[coarse]), bb, 10, 10, 3);

    List<labelPair> found(centres[fine].size());
    forAll(found, i)
    {
        const label nearest = tree.findNearest(centres[fine][i], sqr(GREAT)).index();
        found[i] = labelPair(cells[fine][i], cells[coarse][nearest]);
    }
    return found;
}


Foam::labelList Foam::regionGraph::firstOfVertex
(
    const dictionary& interfaces,
    const UPtrList<const polyMesh>& meshes,
    const labelList& firstCell
) const
{
    // Each cell points to a smaller one of its vertex, the first to itself
    labelList smaller(identity(firstCell.last()));
    const auto first = [&](label i) { while (smaller[i] != i) i = smaller[i]; return i; };
    for (const entry& e : interfaces)
    {
        if (!regions_.found(sides(e.dict())[0].get<word>("region"))) continue;
        for (const labelPair& p : pairs(e.dict(), meshes, firstCell))
        {
            const label a = first(p.first()), b = first(p.second());
            smaller[max(a, b)] = min(a, b);
        }
    }
    forAll(smaller, i) smaller[i] = smaller[smaller[i]];
    return smaller;
}


void Foam::regionGraph::makeVertices
(
    const labelList& first,
    const labelList& firstCell,
    const dictionary& regionWeights
)
{
    labelList vertex(first.size());
    DynamicList<scalar> weight;
    vertex_.setSize(regions_.size());
    forAll(regions_, r)
    {
        const scalar w = regionWeights.lookupOrDefault<scalar>(regions_[r], 1);
        if (w <= 0)
        {
            FatalIOErrorInFunction(regionWeights)
                << "Weight " << w << " of region " << regions_[r]
                << ", expected > 0" << exit(FatalIOError);
        }
        for (label i = firstCell[r]; i < firstCell[r + 1]; ++i)
        {
            if (first[i] == i)
            {
                vertex[i] = weight.size();
                weight.append(0);
            }
            vertex[i] = vertex[first[i]];
            weight[vertex[i]] += w;
        }
        vertex_[r] = SubList<label>(vertex, firstCell[r + 1] - firstCell[r], firstCell[r]);
    }
    weight_.transfer(weight);
}


void Foam::regionGraph::makeEdges(const UPtrList<const polyMesh>& meshes)
{
    List<labelHashSet> neighbours(nVertices());
    forAll(meshes, r)
    {
        const polyMesh& mesh = meshes[r];
        for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
        {
            const label a = vertex_[r][mesh.faceOwner()[facei]];
            const label b = vertex_[r][mesh.faceNeighbour()[facei]];
            if (a == b) continue;
            neighbours[a].insert(b);
            neighbours[b].insert(a);
        }
    }

    start_.setSize(nVertices() + 1);
    start_[0] = 0;
    DynamicList<label> all;
    forAll(neighbours, i)
    {
        all.append(neighbours[i].sortedToc());
        start_[i + 1] = all.size();
    }
    neighbour_.transfer(all);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::regionGraph::regionGraph
(
    const polyMesh& mesh,
    const dictionary& regionWeights
)
{
    const Time& time = mesh.time();
    const IOdictionary coupling
    (
        IOobject
        (
            "couplingProperties", time.constant(), time,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    const dictionary& interfaces = coupling.subDict("interfaces");
    findRegions(interfaces, mesh.name());

    PtrList<polyMesh> others(regions_.size());
    UPtrList<const polyMesh> meshes(regions_.size());
    labelList firstCell(regions_.size() + 1, 0);
    forAll(regions_, r)
    {
        if (regions_[r] != mesh.name())
        {
            others.set(r, new polyMesh(IOobject(regions_[r], time.timeName(), time, IOobject::MUST_READ)));
        }
        meshes.set(r, others.set(r) ? &others[r] : &mesh);
        firstCell[r + 1] = firstCell[r] + meshes[r].nCells();
    }

    makeVertices(firstOfVertex(interfaces, meshes, firstCell), firstCell, regionWeights);
    makeEdges(meshes);
}


// ************************************************************************* //
