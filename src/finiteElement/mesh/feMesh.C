/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feMesh.H"
#include "checkBaffles.H"
#include "feValues.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "cellModel.H"
#include "SubField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feMesh, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::elementBlock& Foam::feMesh::blockOf
(
    List<elementBlock>& blocks,
    const elementShape shape
)
{
    for (elementBlock& block : blocks)
    {
        if (block.shape == shape) return block;
    }
    elementBlock block;
    block.shape = shape;
    block.order = 1;
    blocks.append(block);
    withElement(blocks.last(), [&](auto E) { blocks.last().nNodes = E.nNodes; });
    if (shape == elementShape::LINE) blocks.last().nNodes = 2;
    return blocks.last();
}


void Foam::feMesh::setDirections()
{
    bool empty = false;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        empty = empty || (isA<emptyPolyPatch>(pp) && pp.size());
    }
    reduce(empty, orOp<bool>());

    dim_ = 3;
    axes_ = {0, 1, 2};
    if (!empty) return;

    // The two others follow the empty direction, so that they are right-handed
    dim_ = 2;
    const Vector<label>& geometricD = mesh_.geometricD();
    label nEmpty = 0;
    for (label c = 0; c < 3; ++c)
    {
        if (geometricD[c] < 0)
        {
            axes_ = {(c + 1)%3, (c + 2)%3, c};
            ++nEmpty;
        }
    }
    if (nEmpty != 1)
    {
        FatalErrorInFunction
            << "Region " << mesh_.name() << " has " << nEmpty
            << " empty directions, expected one normal to an axis."
            << " One-dimensional and slanted cases are not supported."
            << exit(FatalError);
    }
}


void Foam::feMesh::addElements()
{
    pointNode_ = identity(mesh_.nPoints());
    vertexPoint_ = pointNode_;

    const cellShapeList& shapes = mesh_.cellShapes();
    const cellModel* models[] =
    {
        cellModel::ptr(cellModel::TET), cellModel::ptr(cellModel::HEX),
        cellModel::ptr(cellModel::PRISM), cellModel::ptr(cellModel::PYR)
    };
    const elementShape types[] =
        {elementShape::TET, elementShape::HEX, elementShape::PRISM, elementShape::PYRAMID};

    List<DynamicList<label>> nodes(4), cells(4);
    forAll(shapes, celli)
    {
        label t = 0;
        while (t < 4 && shapes[celli].model() != *models[t]) ++t;
        if (t == 4)
        {
            FatalErrorInFunction
                << "Cell " << celli << " of region " << mesh_.name() << " at "
                << mesh_.cellCentres()[celli] << " is of type '"
                << shapes[celli].model().name() << "' with "
                << mesh_.cells()[celli].size() << " faces." << nl
                << "Elements are made of tet, hex, prism and pyr cells"
                << " (in 2-D, cells with empty faces of 3 or 4 corners)."
                << exit(FatalError);
        }
        nodes[t].append(shapes[celli]);
        cells[t].append(celli);
    }

    for (label t = 0; t < 4; ++t)
    {
        if (cells[t].empty()) continue;
        elementBlock& block = blockOf(blocks_, types[t]);
        block.nodes.transfer(nodes[t]);
        block.cells.transfer(cells[t]);
    }
}


void Foam::feMesh::addElements2D()
{
    // The empty faces on the positive side of their cells; those of inverted
    // cells, too, which checkOrientation() is to find
    DynamicList<label> faces;
    const label z = axes_[2];
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(pp)) continue;
        forAll(pp, i)
        {
            const label celli = pp.faceCells()[i];
            if (pp.faceCentres()[i][z] > mesh_.cellCentres()[celli][z]) faces.append(pp.start() + i);
        }
    }

    pointNode_.setSize(mesh_.nPoints(), -1);
    DynamicList<label> vertices;
    for (const label facei : faces)
    {
        for (const label p : mesh_.faces()[facei])
        {
            if (pointNode_[p] < 0)
            {
                pointNode_[p] = vertices.size();
                vertices.append(p);
            }
        }
    }
    vertexPoint_.transfer(vertices);

    DynamicList<label> nodes[2], cells[2];
    for (const label facei : faces)
    {
        const face& f = mesh_.faces()[facei];
        if (f.size() != 3 && f.size() != 4)
        {
            FatalErrorInFunction
                << "Cell " << mesh_.faceOwner()[facei] << " of region "
                << mesh_.name() << " at " << mesh_.faceCentres()[facei]
                << " has an empty face of " << f.size() << " corners." << nl
                << "In 2-D, elements are made of triangles and quadrilaterals."
                << exit(FatalError);
        }
        const label t = f.size() - 3;
        for (const label p : f) nodes[t].append(pointNode_[p]);
        cells[t].append(mesh_.faceOwner()[facei]);
    }

    const elementShape types[] = {elementShape::TRI, elementShape::QUAD};
    for (label t = 0; t < 2; ++t)
    {
        if (cells[t].empty()) continue;
        elementBlock& block = blockOf(blocks_, types[t]);
        block.nodes.transfer(nodes[t]);
        block.cells.transfer(cells[t]);
    }

    // The other end of the edges through the depth
    for (const edge& e : mesh_.edges())
    {
        const bool a = pointNode_[e[0]] >= 0, b = pointNode_[e[1]] >= 0;
        if (a == b) continue;
        pointNode_[a ? e[1] : e[0]] = -2 - pointNode_[a ? e[0] : e[1]];
    }
    for (label& n : pointNode_) if (n < -1) n = -2 - n;
}


void Foam::feMesh::addPatches()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    patchBlocks_.setSize(patches.size());
    patchNodes_.setSize(patches.size());

    // In 2-D, a face's edge in the plane, turned as in the element
    EdgeMap<edge> planeEdge;
    if (dim_ == 2)
    {
        for (const elementBlock& block : blocks_)
        {
            for (label e = 0; e < block.size(); ++e)
            {
                const label* v = block.element(e);
                for (label i = 0; i < block.nNodes; ++i)
                {
                    const edge ed(v[i], v[(i + 1) % block.nNodes]);
                    planeEdge.set(ed, ed);
                }
            }
        }
    }

    forAll(patches, patchi)
    {
        const polyPatch& pp = patches[patchi];
        const auto* cyclic = isA<processorCyclicPolyPatch>(pp);
        if (isA<emptyPolyPatch>(pp) || (isA<processorPolyPatch>(pp) && !cyclic)) continue;
        List<elementBlock>& blocks = patchBlocks_[cyclic ? cyclic->referPatchID() : patchi];

        forAll(pp, i)
        {
            labelList nodes;
            if (dim_ == 2)
            {
                DynamicList<label> ends;
                for (const label p : pp[i])
                {
                    if (vertexPoint_[pointNode_[p]] == p) ends.append(pointNode_[p]);
                }
                const edge& e = planeEdge[edge(ends[0], ends[1])];
                // One element at least lies at the edge; the patch has one only
                nodes = labelList({e[0], e[1]});
            }
            else
            {
                nodes = pp[i];
            }
            const elementShape shape =
                dim_ == 2 ? elementShape::LINE
              : nodes.size() == 3 ? elementShape::TRI : elementShape::QUAD;
            elementBlock& block = blockOf(blocks, shape);
            block.nodes.append(nodes);
            block.cells.append(cyclic ? -1 : i);
        }
    }
}


void Foam::feMesh::findPatchNodes()
{
    forAll(patchNodes_, patchi)
    {
        // The indices of all but processor patches are the same on all ranks
        if (isA<processorPolyPatch>(mesh_.boundaryMesh()[patchi])) continue;

        scalarField nRanks(nNodes(), 0);
        for (const elementBlock& block : patchBlocks_[patchi])
        {
            for (const label n : block.nodes) nRanks[n] = 1;
        }
        copies_->sum(nRanks);

        DynamicList<label> nodes;
        forAll(nRanks, n) if (nRanks[n] > 0) nodes.append(n);
        patchNodes_[patchi].transfer(nodes);
    }
}


void Foam::feMesh::checkOrientation()
{
    for (const elementBlock& block : blocks_)
    {
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != dim_) return;
            feValues<double, E> fe;
            Vec<double, E::dim> x[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                for (int i = 0; i < E::nNodes; ++i)
                {
                    const vector& X = points_[block.element(e)[i]];
                    for (int a = 0; a < E::dim; ++a) x[i][a] = X[axes_[a]];
                }
                for (int q = 0; q < fe.nQ; ++q)
                {
                    fe.reinit(x, q);
                    if (fe.detJ > 0) continue;
                    const label celli = block.cells[e];
                    FatalErrorInFunction
                        << "Cell " << celli << " (" << E::name << ") of region "
                        << mesh_.name() << " at " << mesh_.cellCentres()[celli]
                        << " is inverted: determinant of its map " << fe.detJ
                        << ", expected > 0." << nl
                        << "Check the mesh with checkMesh -region "
                        << mesh_.name() << "; at order 2 also the surfaces"
                        << " under curvedPatches." << exit(FatalError);
                }
            }
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feMesh::feMesh
(
    const polyMesh& mesh,
    const label order,
    const dictionary& dict,
    const pointField& points0
)
:
    mesh_(mesh),
    order_(order)
{
    setDirections();
    dim_ == 2 ? addElements2D() : addElements();
    addPatches();

    nVertices_ = vertexPoint_.size();
    points_ = pointField(points0, vertexPoint_);

    EdgeMap<label> edgeNode;
    if (order_ == 2)
    {
        DynamicList<point> points(points_);
        for (elementBlock& block : blocks_) addEdgeNodes(block, edgeNode, points);
        for (List<elementBlock>& blocks : patchBlocks_)
        {
            for (elementBlock& block : blocks) addEdgeNodes(block, edgeNode, points);
        }
        points_.transfer(points);
    }
    makeKeys(edgeNode);
    quadNode_.clear();
    makeParents();
    findPatchNodes();
    if (order_ == 2)
    {
        curvePatches(dict.subOrEmptyDict("curvedPatches"));
        centreNodes();
    }
    for (elementBlock& block : blocks_) block.colour(nNodes());
    checkBaffles(mesh_);
    checkOrientation();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::feMesh::nElements() const
{
    label n = 0;
    for (const elementBlock& block : blocks_) n += block.size();
    return n;
}


Foam::scalar Foam::feMesh::meanSize() const
{
    // Of the reference positions, so that a restart finds the same
    scalar volume = 0;
    for (const elementBlock& block : blocks_)
    {
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != dim_) return;
            feValues<double, E> fe;
            Vec<double, E::dim> x[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                {
                    x[i][a] = points_[block.element(e)[i]][axes_[a]];
                }
                for (int q = 0; q < fe.nQ; ++q)
                {
                    fe.reinit(x, q);
                    volume += fe.dV;
                }
            }
        });
    }
    reduce(volume, sumOp<scalar>());
    return Foam::pow(volume/returnReduce(nElements(), sumOp<label>()), 1.0/dim_);
}


Foam::label Foam::feMesh::patchIndex
(
    const word& name,
    const dictionary& where
) const
{
    const label patchi = mesh_.boundaryMesh().findPatchID(name);
    if (patchi < 0)
    {
        FatalIOErrorInFunction(where)
            << "Region " << mesh_.name() << " has no patch '" << name
            << "'. Its patches are " << mesh_.boundaryMesh().names()
            << exit(FatalIOError);
    }
    return patchi;
}


Foam::labelList Foam::feMesh::patchIndices
(
    const wordRes& names,
    const dictionary& where
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    wordList valid;
    labelHashSet physical;
    for (const polyPatch& pp : patches)
    {
        if (isA<emptyPolyPatch>(pp) || isA<processorPolyPatch>(pp)) continue;
        valid.append(pp.name());
        physical.insert(pp.index());
    }
    if (names.empty())
    {
        FatalIOErrorInFunction(where)
            << "The list of patches is empty. Region " << mesh_.name()
            << " has the patches " << valid << exit(FatalIOError);
    }

    labelHashSet indices;
    for (const wordRe& name : names)
    {
        labelHashSet found(patches.patchSet(wordRes(one(), name), false));
        found &= physical;
        if (found.empty())
        {
            FatalIOErrorInFunction(where)
                << "Region " << mesh_.name() << " has no patch '"
                << name.c_str() << "'. Its patches are " << valid
                << " and its groups " << patches.groupPatchIDs().sortedToc()
                << exit(FatalIOError);
        }
        indices |= found;
    }
    return indices.sortedToc();
}


Foam::tmp<Foam::pointField> Foam::feMesh::movedPoints
(
    const vectorField& displacement
) const
{
    tmp<pointField> tpoints(new pointField(mesh_.points()));
    pointField& points = tpoints.ref();
    forAll(pointNode_, p)
    {
        const label n = pointNode_[p];
        if (n < 0) continue;
        for (label a = 0; a < dim_; ++a)
        {
            const label c = axes_[a];
            points[p][c] = points_[n][c] + displacement[n][c];
        }
    }
    return tpoints;
}


// ************************************************************************* //
