/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicNodes.H"
#include "feValues.H"
#include "gatherAll.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"
#include "transform.H"
#include "quaternion.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Area vector and centroid of a patch over all ranks
struct wholePatch
{
    vector S = Zero;
    point C = Zero;

    wholePatch(const feMesh& fe, const label patchi)
    {
        scalar area = 0;
        for (const elementBlock& block : fe.patchBlocks(patchi))
        {
            withFaceElement(block, [&](auto tag)
            {
                typedef decltype(tag) F;
                faceValues<double, F> face;
                Vec<double, face.dim> x[F::nNodes];
                if (face.dim != fe.dim()) return;
                for (label e = 0; e < block.size(); ++e)
                {
                    const label* n = block.element(e);
                    for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < face.dim; ++a)
                    {
                        x[i][a] = fe.points()[n[i]][fe.axis(a)];
                    }
                    for (int q = 0; q < face.nQ; ++q)
                    {
                        face.reinit(x, q);
                        const scalar dA = ::sqrt(face.ndA & face.ndA);
                        area += dA;
                        for (int a = 0; a < face.dim; ++a)
                        {
                            S[fe.axis(a)] += face.ndA[a];
                            for (int i = 0; i < F::nNodes; ++i) C[fe.axis(a)] += face.N[i]*x[i][a]*dA;
                        }
                    }
                }
            });
        }
        reduce(area, sumOp<scalar>());
        reduce(S, sumOp<vector>());
        reduce(C, sumOp<vector>());
        C /= max(area, VSMALL);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cyclicNodes::match(const cyclicPolyPatch& patch)
{
    const polyBoundaryMesh& patches = fe_.mesh().boundaryMesh();
    const label owner = patch.index(), neighbour = patch.neighbPatchID();
    const wholePatch from(fe_, owner), to(fe_, neighbour);

    // Both halves look out of the mesh
    half h{&patch, tensor::I, fe_.patchNodes(neighbour), {}, {}};
    const vector n = from.S/max(mag(from.S), VSMALL), m = -to.S/max(mag(to.S), VSMALL);
    point centre = Zero;
    vector shift = to.C - from.C;
    vector axis = Zero;
    if (mag(n - m) > 1e-6)
    {
        axis = patch.rotationAxis();
        centre = patch.rotationCentre();
        if (patch.transform() != coupledPolyPatch::ROTATIONAL || mag(axis) < VSMALL)
        {
            FatalErrorInFunction
                << "Cyclic patches " << patch.name() << " and " << patches[neighbour].name()
                << " of region " << fe_.mesh().name() << " are not parallel: normals "
                << n << " and " << m << '.' << nl
                << "Expected transform rotational, rotationAxis and rotationCentre in"
                << " constant/polyMesh/boundary" << exit(FatalError);
        }
        axis /= mag(axis);
        const vector a = n - (n & axis)*axis, b = m - (m & axis)*axis;
        const scalar angle = ::atan2((a ^ b) & axis, a & b);
        h.R = quaternion(axis, angle).R();
        shift = Zero;
    }
    if (fe_.dim() == 2) shift[fe_.axis(2)] = 0;

    // In 2-D the halves may be seen at different depths
    const auto flat = [&](point x) { if (fe_.dim() == 2) x[fe_.axis(2)] = 0; return x; };

    pointField masters(gatherAll<point>(pointField(fe_.points(), fe_.patchNodes(owner))));
    for (point& x : masters) x = flat(centre + (h.R & (x - centre)) + shift);
    const labelList masterKeys(gatherAll<label>(UIndirectList<label>(fe_.key(), fe_.patchNodes(owner))()));
    if (masters.empty()) return;

    treeBoundBox bb(masters);
    const scalar tolerance = patch.matchTolerance()*fe_.meanSize();
    bb.inflate(0.01);
    bb.min() -= vector::uniform(SMALL + 1e-3*bb.mag());
    bb.max() += vector::uniform(SMALL + 1e-3*bb.mag());
    const indexedOctree<treeDataPoint> tree(treeDataPoint(masters), bb, 10, 10, 3);

    h.partner.setSize(h.slaves.size());
    h.onAxis.setSize(h.slaves.size(), false);
    forAll(h.slaves, i)
    {
        const point x = flat(fe_.points()[h.slaves[i]]);
        const pointIndexHit hit = tree.findNearest(x, sqr(GREAT));
        h.partner[i] = hit.index();
        if (mag(x - hit.hitPoint()) > tolerance)
        {
            FatalErrorInFunction
                << "Cyclic patches " << patch.name() << " and " << patches[neighbour].name()
                << " of region " << fe_.mesh().name() << " do not match: the node at "
                << fe_.points()[h.slaves[i]] << " has no partner within " << tolerance
                << " m, the nearest is " << mag(x - hit.hitPoint()) << " m away."
                << " Both halves need the same points" << exit(FatalError);
        }
        h.onAxis[i] = masterKeys[h.partner[i]] == fe_.key()[h.slaves[i]];
    }
    halves_.append(h);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cyclicNodes::cyclicNodes(const feMesh& fe)
:
    fe_(fe)
{
    for (const polyPatch& pp : fe.mesh().boundaryMesh())
    {
        if (!isA<cyclicPolyPatch>(pp)) continue;
        const cyclicPolyPatch& patch = refCast<const cyclicPolyPatch>(pp);
        if (patch.owner()) match(patch);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
bool Foam::cyclicNodes::follow(Field<Type>& values) const
{
    bool changed = false;
    for (const half& h : halves_)
    {
        // Fields of vertices have no values at mid-side nodes
        const labelList& nodes = fe_.patchNodes(h.patch->index());
        Field<Type> mine(nodes.size(), Zero);
        forAll(nodes, i) if (nodes[i] < values.size()) mine[i] = values[nodes[i]];
        const List<Type> masters(gatherAll<Type>(mine));

        forAll(h.slaves, i)
        {
            if (h.slaves[i] >= values.size() || h.onAxis[i]) continue;
            const Type value(transform(h.R, masters[h.partner[i]]));
            Type& slave = values[h.slaves[i]];
            if (mag(slave - value) <= 1e-12*mag(value)) continue;
            slave = value;
            changed = true;
        }
    }
    return changed;
}

namespace Foam
{
    template bool cyclicNodes::follow(scalarField&) const;
    template bool cyclicNodes::follow(vectorField&) const;
}


void Foam::cyclicNodes::tie
(
    const fieldUnknowns& unknowns,
    const label f,
    dofConstraints& c
) const
{
    typedef dofConstraints::term term;
    const fieldLayout& layout = unknowns.layout();
    const bool isVector = layout[f].is == fieldLayout::kind::VECTOR;

    for (const half& h : halves_)
    {
        // First unknown, by global number, of the owner's nodes of all ranks
        const labelList& nodes = fe_.patchNodes(h.patch->index());
        labelList mine(nodes.size(), -1);
        forAll(nodes, i)
        {
            if (layout.value(f, nodes[i]) >= 0)
            {
                mine[i] = unknowns.map().global(unknowns.start(f, nodes[i]));
            }
        }
        const labelList masters(gatherAll<label>(mine));

        forAll(h.slaves, i)
        {
            if (layout.value(f, h.slaves[i]) < 0) continue;
            const label slave = unknowns.start(f, h.slaves[i]), master = masters[h.partner[i]];
            if (!isVector)
            {
                if (!h.onAxis[i]) c.tieGlobal(slave, List<term>(1, term{master, 1}));
                continue;
            }
            for (label a = 0; a < fe_.dim(); ++a)
            {
                DynamicList<term> row;
                for (label b = 0; b < fe_.dim(); ++b)
                {
                    // On the axis only the component along it is left
                    const scalar w =
                        h.onAxis[i]
                      ? h.patch->rotationAxis()[fe_.axis(a)]*h.patch->rotationAxis()[fe_.axis(b)]
                       /magSqr(h.patch->rotationAxis())
                      : h.R(fe_.axis(a), fe_.axis(b));
                    if (mag(w) > 1e-12) row.append({master + b, w});
                }
                if (h.onAxis[i])
                {
                    // Of an axis along a direction of the case
                    if (row.size() == 1 && row[0].unknown == master + a) continue;
                    row.clear();
                }
                c.tieGlobal(slave + a, row);
            }
        }
    }
}


// ************************************************************************* //
