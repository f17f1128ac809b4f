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
#include <algorithm>
#include "syncTools.H"
#include "globalIndex.H"
#include "SortableList.H"

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


void Foam::feMesh::curvePatches
(
    const dictionary& dict,
    const EdgeMap<label>& edgeNode
)
{
    vectorField move(nNodes(), Zero);

    for (const entry& dEntry : dict)
    {
        const word name(dEntry.keyword());
        const label patchi = patchIndex(name, dict);
        const autoPtr<searchableSurface> surface = searchableSurface::New
        (
            dEntry.dict().get<word>("type"),
            IOobject
            (
                name, mesh_.time().constant(), "triSurface", mesh_.time(),
                IOobject::MUST_READ, IOobject::NO_WRITE, false
            ),
            dEntry.dict()
        );

        for (const elementBlock& block : patchBlocks_[patchi])
        {
            const secondOrder s = secondOrder::of(block.shape);
            for (label e = 0; e < block.size(); ++e)
            {
                const label* n = block.element(e);
                pointField mid(s.nEdges);
                scalarField radiusSqr(s.nEdges);
                for (label i = 0; i < s.nEdges; ++i)
                {
                    const point& a = points_[n[s.edges[i][0]]];
                    const point& b = points_[n[s.edges[i][1]]];
                    mid[i] = 0.5*(a + b);
                    radiusSqr[i] = magSqr(b - a);
                }
                List<pointIndexHit> hits;
                surface->findNearest(mid, radiusSqr, hits);
                for (label i = 0; i < s.nEdges; ++i)
                {
                    if (!hits[i].hit())
                    {
                        FatalIOErrorInFunction(dEntry.dict())
                            << "Patch " << name << " of region " << mesh_.name()
                            << ": no point of the surface within "
                            << ::sqrt(radiusSqr[i]) << " m of the mid-side node at "
                            << mid[i] << exit(FatalIOError);
                    }
                    vector d = hits[i].hitPoint() - mid[i];
                    if (dim_ == 2) d[axes_[2]] = 0;
                    move[n[s.nVertices + i]] = d;
                }
            }
        }
    }

    // An edge of the patch may belong to a rank that has no face there
    vectorField edgeMove(mesh_.nEdges(), Zero);
    labelList nodeOfEdge(mesh_.nEdges(), -1);
    forAll(mesh_.edges(), i)
    {
        const edge& e = mesh_.edges()[i];
        const label a = pointNode_[e[0]], b = pointNode_[e[1]];
        if (vertexPoint_[a] != e[0] || vertexPoint_[b] != e[1]) continue;
        const auto found = edgeNode.cfind(edge(a, b));
        if (found.found())
        {
            nodeOfEdge[i] = *found;
            edgeMove[i] = move[*found];
        }
    }
    syncTools::syncEdgeList(mesh_, edgeMove, maxMagSqrEqOp<vector>(), vector::zero);
    forAll(nodeOfEdge, i) if (nodeOfEdge[i] >= 0) points_[nodeOfEdge[i]] += edgeMove[i];
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


void Foam::feMesh::makeKeys(const EdgeMap<label>& edgeNode)
{
    const globalIndex numbering(nNodes());
    key_.setSize(nNodes());
    forAll(key_, n) key_[n] = numbering.toGlobal(n);
    if (!Pstream::parRun()) return;

    // Every copy takes the smallest of their numbers
    labelList pointKey(mesh_.nPoints(), labelMax);
    forAll(vertexPoint_, n) pointKey[vertexPoint_[n]] = key_[n];
    syncTools::syncPointList(mesh_, pointKey, minEqOp<label>(), labelMax);
    forAll(vertexPoint_, n) key_[n] = pointKey[vertexPoint_[n]];
    if (order_ == 1) return;

    const auto edgeNodeOf = [&](const edge& e)
    {
        const label a = pointNode_[e[0]], b = pointNode_[e[1]];
        if (vertexPoint_[a] != e[0] || vertexPoint_[b] != e[1]) return label(-1);
        const auto found = edgeNode.cfind(edge(a, b));
        return found.found() ? *found : label(-1);
    };
    labelList edgeKey(mesh_.nEdges(), labelMax);
    forAll(edgeKey, i)
    {
        const label n = edgeNodeOf(mesh_.edges()[i]);
        if (n >= 0) edgeKey[i] = key_[n];
    }
    syncTools::syncEdgeList(mesh_, edgeKey, minEqOp<label>(), labelMax);
    forAll(edgeKey, i)
    {
        const label n = edgeNodeOf(mesh_.edges()[i]);
        if (n >= 0) key_[n] = edgeKey[i];
    }
    if (dim_ == 2) return;

    const auto quadNodeOf = [&](const face& f)
    {
        if (f.size() != 4) return label(-1);
        quadKey key;
        forAll(f, j) key[j] = f[j];
        std::sort(key.begin(), key.end());
        const auto found = quadNode_.cfind(key);
        return found.found() ? *found : label(-1);
    };
    labelList faceKey(mesh_.nFaces(), labelMax);
    forAll(faceKey, i)
    {
        const label n = quadNodeOf(mesh_.faces()[i]);
        if (n >= 0) faceKey[i] = key_[n];
    }
    syncTools::syncFaceList(mesh_, faceKey, minEqOp<label>());
    forAll(faceKey, i)
    {
        const label n = quadNodeOf(mesh_.faces()[i]);
        if (n >= 0) key_[n] = faceKey[i];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feMesh::parents(List<labelList>& parent) const
{
    parent.setSize(nNodes());
    if (order_ == 1) return;

    for (const elementBlock& block : blocks_)
    {
        const secondOrder s = secondOrder::of(block.shape);
        for (label e = 0; e < block.size(); ++e)
        {
            const label* n = block.element(e);
            for (label i = 0; i < s.nEdges; ++i)
            {
                parent[n[s.nVertices + i]] = labelList({n[s.edges[i][0]], n[s.edges[i][1]]});
            }
            for (label i = 0; i < s.nQuads; ++i)
            {
                labelList& p = parent[n[s.nVertices + s.nEdges + i]];
                p.setSize(4);
                for (label j = 0; j < 4; ++j) p[j] = n[s.quads[i][j]];
            }
            if (s.solid)
            {
                labelList& p = parent[n[26]];
                p.setSize(8);
                for (label j = 0; j < 8; ++j) p[j] = n[j];
            }
        }
    }
}


// ************************************************************************* //
