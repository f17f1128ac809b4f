/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "simplexExchange.H"
#include "emptyPolyPatch.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::simplexExchange::key(const face& f)
{
    labelList k(f);
    Foam::sort(k);
    return k;
}


void Foam::simplexExchange::findDepth()
{
    const label z = fe_.axis(2);
    twin_.setSize(fe_.nVertices(), -1);
    forAll(fe_.pointNode(), p)
    {
        const label n = fe_.pointNode()[p];
        if (n >= 0 && fe_.vertexPoint()[n] != p) twin_[n] = p;
    }
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp)) continue;
        forAll(pp, i)
        {
            const label c = pp.faceCells()[i];
            if (!replaced_[c]) continue;
            const label end = pp.faceCentres()[i][z] > mesh_.cellCentres()[c][z] ? 0 : 1;
            emptyPatch_[end] = pp.index();
            depth_[end] = points_[pp[i][0]][z];
        }
    }
}


void Foam::simplexExchange::addKept()
{
    forAll(mesh_.faces(), f)
    {
        const label own = mesh_.faceOwner()[f];
        const bool internal = mesh_.isInternalFace(f);
        const label nei = internal ? mesh_.faceNeighbour()[f] : -1;
        const label patch = internal ? -1 : mesh_.boundaryMesh().whichPatch(f);
        if (replaced_[own] && internal && replaced_[nei]) continue;
        if (replaced_[own] && !internal && isA<emptyPolyPatch>(mesh_.boundaryMesh()[patch])) continue;

        side s{mesh_.faces()[f], newCell_[own], internal ? newCell_[nei] : label(OUTSIDE), patch, f};
        if (internal && replaced_[own])
        {
            s.f.flip();
            std::swap(s.in, s.out);
        }
        if (replaced_[own] || (internal && replaced_[nei])) open_.insert(key(s.f), sides_.size());
        sides_.append(s);
    }
}


void Foam::simplexExchange::addSide(const face& f, const label cell, const label patch)
{
    if (patch >= 0)
    {
        sides_.append({f, cell, OUTSIDE, patch, -1});
        return;
    }
    const labelList k(key(f));
    const label other = open_.lookup(k, -1);
    if (other < 0)
    {
        open_.insert(k, sides_.size());
        sides_.append({f, cell, NONE, -1, -1});
        return;
    }
    side& s = sides_[other];
    (s.in == NONE ? s.in : s.out) = cell;
    open_.erase(k);
}


void Foam::simplexExchange::addCell(const label cell, const labelUList& p)
{
    if (fe_.dim() == 3)
    {
        const label faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        for (const auto& f : faces) addSide(face(labelList({p[f[0]], p[f[1]], p[f[2]]})), cell, -1);
        return;
    }

    // The triangle in front, its other end behind
    addSide(face(labelList({p[0], p[1], p[2]})), cell, emptyPatch_[0]);
    addSide(face(labelList({p[5], p[4], p[3]})), cell, emptyPatch_[1]);
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1)%3;
        addSide(face(labelList({p[i + 3], p[j + 3], p[j], p[i]})), cell, -1);
    }
}


void Foam::simplexExchange::order(meshExchange& e)
{
    for (side& s : sides_)
    {
        if (s.out == OUTSIDE || s.in < s.out) continue;
        std::swap(s.in, s.out);
        s.f.flip();
    }
    const auto rank = [](const side& s)
    {
        return std::make_pair(s.patch, s.patch < 0 ? std::make_pair(s.in, s.out) : std::make_pair(label(0), label(0)));
    };
    std::stable_sort
    (
        sides_.begin(), sides_.end(),
        [&](const side& a, const side& b) { return rank(a) < rank(b); }
    );
    const label n = sides_.size(), nPatches = mesh_.boundaryMesh().size();
    e.faces.setSize(n);
    e.owner.setSize(n);
    e.faceMap.setSize(n);
    e.patchSizes = labelList(nPatches, 0);
    e.patchStarts = labelList(nPatches, 0);
    DynamicList<label> neighbour;
    forAll(sides_, i)
    {
        const side& s = sides_[i];
        e.faces[i] = s.f;
        e.owner[i] = s.in;
        e.faceMap[i] = s.old;
        if (s.patch < 0) neighbour.append(s.out);
        else ++e.patchSizes[s.patch];
    }
    e.neighbour.transfer(neighbour);
    label start = e.neighbour.size();
    forAll(e.patchStarts, p)
    {
        e.patchStarts[p] = start;
        start += e.patchSizes[p];
    }
}


void Foam::simplexExchange::compact(meshExchange& e) const
{
    // Old points in their order, then the new ones
    labelList number(points_.size(), -1);
    for (const face& f : e.faces) for (const label p : f) number[p] = 0;
    DynamicList<label> map;
    DynamicList<point> points;
    forAll(number, p)
    {
        if (number[p] < 0) continue;
        number[p] = points.size();
        points.append(points_[p]);
        map.append(p < mesh_.nPoints() ? p : -1);
    }
    for (face& f : e.faces) for (label& p : f) p = number[p];
    e.points.transfer(points);
    e.pointMap.transfer(map);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::simplexExchange::simplexExchange
(
    const feMesh& fe,
    const pointField& points,
    const labelUList& cells
)
:
    fe_(fe),
    mesh_(fe.mesh()),
    replaced_(mesh_.nCells(), false),
    newCell_(mesh_.nCells(), label(NONE)),
    depth_{0, 0},
    emptyPatch_{-1, -1},
    points_(points)
{
    for (const label c : cells) replaced_[c] = true;
    label n = 0;
    forAll(newCell_, c) if (!replaced_[c]) newCell_[c] = n++;
    if (fe.dim() == 2) findDepth();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::simplexExchange::make
(
    const simplexMesh& now,
    const labelUList& nodes,
    meshExchange& e
)
{
    sides_.clear();
    open_.clear();
    addKept();

    // Points of each new node: in 2-D front and back
    const bool plane = fe_.dim() == 2;
    labelList at(now.points.size()), behind(at);
    forAll(at, i)
    {
        if (now.origin[i] >= 0)
        {
            const label n = nodes[now.origin[i]];
            at[i] = fe_.vertexPoint()[n];
            if (plane) behind[i] = twin_[n];
            continue;
        }
        point p = Zero;
        for (label a = 0; a < fe_.dim(); ++a) p[fe_.axis(a)] = now.points[i][a];
        for (label end = 0; end < (plane ? 2 : 1); ++end)
        {
            if (plane) p[fe_.axis(2)] = depth_[end];
            (end ? behind : at)[i] = points_.size();
            points_.append(p);
        }
    }

    e.cellMap.clear();
    forAll(replaced_, c) if (!replaced_[c]) e.cellMap.append(c);
    for (const labelList& cell : now.cells)
    {
        labelList p(UIndirectList<label>(at, cell));
        if (plane) p.append(labelList(UIndirectList<label>(behind, cell)));
        addCell(e.cellMap.size(), p);
        e.cellMap.append(-1);
    }
    if (!open_.empty())
    {
        return Foam::name(open_.size()) + " faces of the new cells and of the boundary do not meet";
    }
    order(e);
    compact(e);
    return "";
}


// ************************************************************************* //
