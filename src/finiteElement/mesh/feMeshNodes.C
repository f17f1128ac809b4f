/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The nodes of order 2, and the keys under which ranks know a node.
\*---------------------------------------------------------------------------*/

#include "feMesh.H"
#include "searchableSurface.H"
#include "Time.H"
#include "processorPolyPatch.H"
#include "PstreamBuffers.H"
#include "globalIndex.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Edges, quadrilaterals and sizes of a volume or face element of order 2
struct secondOrder
{
    label nNodes, nVertices, nEdges, nQuads;
    const int (*edges)[2];
    const int (*quads)[4];
    bool solid;

    template<class E>
    static secondOrder of(const E&)
    {
        typedef typename E::Linear L;
        static_assert(E::order == 2 && L::nNodes == E::nVertices, "order 2");
        return {E::nNodes, E::nVertices, E::nEdges, E::nQuads, E::edges, E::quads, E::nNodes == 27};
    }

    static secondOrder of(const elementShape shape)
    {
        switch (shape)
        {
            case elementShape::LINE: return of(Line2());
            case elementShape::TRI: return of(Tri2());
            case elementShape::QUAD: return of(Quad2());
            case elementShape::TET: return of(Tet2());
            case elementShape::HEX: return of(Hex2());
            default: break;
        }
        FatalErrorInFunction
            << "The mesh has " << elementName(shape) << " cells, which have no"
            << " element of order 2." << nl
            << "Use order 1 elements (equalOrder, linear), or tet and hex cells."
            << exit(FatalError);
        return of(Line2());
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::feMesh::addEdgeNodes
(
    elementBlock& block,
    EdgeMap<label>& edgeNode,
    DynamicList<point>& points
)
{
    const secondOrder s = secondOrder::of(block.shape);
    labelList nodes(block.size()*s.nNodes);

    const auto newNode = [&]() { points.append(Zero); return points.size() - 1; };

    for (label e = 0; e < block.size(); ++e)
    {
        const label* v = block.element(e);
        label* n = &nodes[e*s.nNodes];
        for (label i = 0; i < s.nVertices; ++i) *n++ = v[i];

        for (label i = 0; i < s.nEdges; ++i)
        {
            const edge ed(v[s.edges[i][0]], v[s.edges[i][1]]);
            auto found = edgeNode.find(ed);
            if (!found.found())
            {
                edgeNode.insert(ed, newNode());
                found = edgeNode.find(ed);
                points.last() = 0.5*(points[ed[0]] + points[ed[1]]);
            }
            *n++ = *found;
        }
        for (label i = 0; i < s.nQuads; ++i)
        {
            quadKey key;
            for (label j = 0; j < 4; ++j) key[j] = v[s.quads[i][j]];
            std::sort(key.begin(), key.end());
            if (!quadNode_.found(key)) quadNode_.insert(key, newNode());
            *n++ = quadNode_[key];
        }
        if (s.solid) *n++ = newNode();
    }
    block.nodes.transfer(nodes);
    block.nNodes = s.nNodes;
    block.order = 2;
}


void Foam::feMesh::curvePatch
(
    const label patchi,
    const dictionary& dict,
    vectorField& move
) const
{
    const word& name = mesh_.boundaryMesh()[patchi].name();
    const autoPtr<searchableSurface> surface = searchableSurface::New
    (
        dict.get<word>("type"),
        IOobject
        (
            name, mesh_.time().constant(), "triSurface", mesh_.time(),
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        ),
        dict
    );

    DynamicList<label> nodes;
    for (const label n : patchNodes(patchi))
    {
        if (parents_[n].size() == 2) nodes.append(n);
    }
    pointField mid(nodes.size());
    scalarField radiusSqr(nodes.size());
    forAll(nodes, i)
    {
        const point& a = points_[parents_[nodes[i]][0]];
        const point& b = points_[parents_[nodes[i]][1]];
        mid[i] = 0.5*(a + b);
        radiusSqr[i] = magSqr(b - a);
    }
    List<pointIndexHit> hits;
    surface->findNearest(mid, radiusSqr, hits);
    forAll(nodes, i)
    {
        if (!hits[i].hit())
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << name << " of region " << mesh_.name()
                << ": no point of the surface within " << ::sqrt(radiusSqr[i])
                << " m of the mid-side node at " << mid[i] << exit(FatalIOError);
        }
        vector& d = move[nodes[i]];
        d = hits[i].hitPoint() - mid[i];
        if (dim_ == 2) d[axes_[2]] = 0;
    }
}


void Foam::feMesh::curvePatches(const dictionary& dict)
{
    vectorField move(nNodes(), Zero);
    for (const entry& e : dict)
    {
        curvePatch(patchIndex(e.keyword(), dict), e.dict(), move);
    }
    points_ += move;
}


void Foam::feMesh::centreNodes()
{
    // Blending of a curved quadrilateral and of a curved hexahedron:
    // (sum of mid-sides)/2 - (sum of corners)/4, and (sum of faces)/2 -
    // (sum of mid-sides)/4 + (sum of corners)/8
    for (const elementBlock& block : blocks_)
    {
        const secondOrder s = secondOrder::of(block.shape);
        if (!s.nQuads) continue;
        for (label e = 0; e < block.size(); ++e)
        {
            const label* n = block.element(e);
            for (label i = 0; i < s.nQuads; ++i)
            {
                point c = Zero;
                for (label j = 0; j < 4; ++j)
                {
                    const int v = s.quads[i][j], w = s.quads[i][(j + 1)%4];
                    c -= 0.25*points_[n[v]];
                    for (label k = 0; k < s.nEdges; ++k)
                    {
                        const int a = s.edges[k][0], b = s.edges[k][1];
                        if ((a == v && b == w) || (a == w && b == v))
                        {
                            c += 0.5*points_[n[s.nVertices + k]];
                        }
                    }
                }
                points_[n[s.nVertices + s.nEdges + i]] = c;
            }
            if (!s.solid) continue;
            point c = Zero;
            for (label i = 0; i < 8; ++i) c += 0.125*points_[n[i]];
            for (label i = 8; i < 20; ++i) c -= 0.25*points_[n[i]];
            for (label i = 20; i < 26; ++i) c += 0.5*points_[n[i]];
            points_[n[26]] = c;
        }
    }
}


void Foam::feMesh::makeParents()
{
    parents_.setSize(nNodes());
    if (order_ == 1) return;

    for (const elementBlock& block : blocks_)
    {
        const secondOrder s = secondOrder::of(block.shape);
        for (label e = 0; e < block.size(); ++e)
        {
            const label* n = block.element(e);
            for (label i = 0; i < s.nEdges; ++i)
            {
                parents_[n[s.nVertices + i]] = labelList({n[s.edges[i][0]], n[s.edges[i][1]]});
            }
            for (label i = 0; i < s.nQuads; ++i)
            {
                labelList& p = parents_[n[s.nVertices + s.nEdges + i]];
                p.setSize(4);
                for (label j = 0; j < 4; ++j) p[j] = n[s.quads[i][j]];
            }
            if (s.solid)
            {
                labelList& p = parents_[n[26]];
                p.setSize(8);
                for (label j = 0; j < 8; ++j) p[j] = n[j];
            }
        }
    }
}


Foam::labelList Foam::feMesh::processorNodes
(
    const processorPolyPatch& pp,
    const EdgeMap<label>& edgeNode
) const
{
    DynamicList<label> nodes;
    for (const face& f : pp)
    {
        // The neighbour's face has the same first point and turns back
        const face g(pp.owner() ? f : f.reverseFace());
        forAll(g, i)
        {
            const label a = pointNode_[g[i]], b = pointNode_[g.nextLabel(i)];
            nodes.append(a);
            const auto found = edgeNode.cfind(edge(a, b));
            if (found.found()) nodes.append(*found);
        }
        if (dim_ == 2 || f.size() != 4) continue;
        quadKey key(f);
        std::sort(key.begin(), key.end());
        const auto found = quadNode_.cfind(key);
        if (found.found()) nodes.append(*found);
    }
    return labelList(nodes);
}


void Foam::feMesh::makeKeys(const EdgeMap<label>& edgeNode)
{
    const globalIndex numbering(nNodes());
    key_.setSize(nNodes());
    forAll(key_, n) key_[n] = numbering.toGlobal(n);

    // Not those of cyclics, which syncTools would join
    DynamicList<label> neighbours;
    DynamicList<labelList> shared;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isType<processorPolyPatch>(pp)) continue;
        const auto& processorPatch = refCast<const processorPolyPatch>(pp);
        neighbours.append(processorPatch.neighbProcNo());
        shared.append(processorNodes(processorPatch, edgeNode));
    }

    // Every copy takes the smallest number, handed on from rank to rank
    bool changed = Pstream::parRun();
    while (changed)
    {
        changed = false;
        PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
        forAll(neighbours, i)
        {
            UOPstream toNeighbour(neighbours[i], buffers);
            toNeighbour << labelList(UIndirectList<label>(key_, shared[i]));
        }
        buffers.finishedSends();
        forAll(neighbours, i)
        {
            UIPstream fromNeighbour(neighbours[i], buffers);
            const labelList theirs(fromNeighbour);
            forAll(theirs, j)
            {
                label& key = key_[shared[i][j]];
                changed = changed || theirs[j] < key;
                key = min(key, theirs[j]);
            }
        }
        reduce(changed, orOp<bool>());
    }
    copies_.reset(new nodeMap(key_, labelList(nNodes(), 1)));
}


// ************************************************************************* //
