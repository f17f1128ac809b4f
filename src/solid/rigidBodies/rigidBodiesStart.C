/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The bodies of a mesh, and where they are by the nodes' own motion.
\*---------------------------------------------------------------------------*/

#include "rigidBodies.H"
#include "rotation.H"
#include "gatherAll.H"
#include "boundBox.H"
#include "cyclicPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rigidBodies::add
(
    const label patchi,
    const pointVectorField& pointD,
    const nodalBoundary& boundary
)
{
    body b;
    b.patch = pointD.boundaryField()[patchi].patch().name();
    b.support = dynamic_cast<const rigidSupport*>(&pointD.boundaryField()[patchi]);
    b.nodes = fe_.patchNodes(patchi);
    if (returnReduce(b.nodes.empty(), andOp<bool>()))
    {
        FatalErrorInFunction
            << "rigidPatch " << b.patch << " of region " << fe_.mesh().name()
            << " has no faces" << exit(FatalError);
    }
    for (label d = 0; d < rigidSupport::nDirections; ++d)
    {
        if (directions_.found(d) || !b.support->isFree(d)) continue;
        FatalErrorInFunction
            << "rigidPatch " << b.patch << " of region " << fe_.mesh().name()
            << " has a load in a direction that a 2-D case has not" << exit(FatalError);
    }

    const boundBox bounds(pointField(fe_.points(), b.nodes), true);
    b.size = bounds.mag();
    b.centre = b.support->centre() ? *b.support->centre() : bounds.midpoint();
    b.arms = vectorField(fe_.points(), b.nodes) - b.centre;
    if (fe_.dim() == 2) for (vector& X : b.arms) X[fe_.axis(2)] = 0;
    checkNodes(b, boundary);
    findAnchors(b);
    b.force = b.moment = Zero;
    bodies_.append(b);
}


void Foam::rigidBodies::checkNodes
(
    const body& b,
    const nodalBoundary& boundary
) const
{
    const auto fail = [&](const label n, const string& what)
    {
        FatalErrorInFunction
            << "rigidPatch " << b.patch << " of region " << fe_.mesh().name()
            << " has a node at " << fe_.points()[n] << " that is also on " << what.c_str()
            << exit(FatalError);
    };
    for (const polyPatch& p : fe_.mesh().boundaryMesh())
    {
        const auto* cyclic = isA<cyclicPolyPatch>(p);
        if (!cyclic || cyclic->parallel()) continue;
        const labelHashSet turned(fe_.patchNodes(p.index()));
        for (const label n : b.nodes) if (turned.found(n))
        {
            fail(n, "patch " + p.name() + ", a cyclic one that turns: the body needs all the way round");
        }
    }
    for (const label n : b.nodes)
    {
        if (boundary.hasValue(n)) fail(n, "patch " + boundary.patchName(n) + ", where all is given");
        for (const body& other : bodies_)
        {
            if (other.nodes.found(n)) fail(n, "rigidPatch " + other.patch + ": give both one patch");
        }
        for (const vector& normal : boundary.givenDirections(n)) for (const label d : directions_)
        {
            // A turn about the normal leaves the plane as it is
            const bool turn = d >= rigidSupport::ROTATION;
            const scalar along = mag(normal[d % rigidSupport::ROTATION]);
            if (!b.support->isFree(d) || (turn ? along > 1 - 1e-6 : along < 1e-6)) continue;
            fail
            (
                n,
                "patch " + boundary.patchName(n) + ", which gives the component along ("
              + Foam::name(normal.x()) + ' ' + Foam::name(normal.y()) + ' ' + Foam::name(normal.z())
              + "): the patch must not be free to leave it, by translations along it and"
                " rotations about other axes"
            );
        }
    }
}


void Foam::rigidBodies::findAnchors(body& b) const
{
    const pointField all(gatherAll<point>(pointField(b.arms)));
    const auto farthest = [&](const auto& distance)
    {
        label most = 0;
        forAll(all, i) if (distance(all[i]) > (1 + 1e-6)*distance(all[most])) most = i;
        return all[most];
    };
    const vector first(all[0]), second(farthest([&](const vector& X) { return mag(X - first); }));
    b.anchors = List<point>({first, second});
    if (fe_.dim() == 2) return;
    b.anchors.append(farthest([&](const vector& X) { return mag((X - first) ^ (second - first)); }));
}


Foam::List<Foam::vector> Foam::rigidBodies::atAnchors
(
    const body& b,
    const vectorField& values
) const
{
    // The mean of the copies of a node
    List<vector> sum(b.anchors.size(), Zero);
    scalarList n(b.anchors.size(), scalar(0));
    forAll(b.anchors, k) forAll(b.nodes, i)
    {
        if (b.arms[i] != b.anchors[k]) continue;
        sum[k] += values[b.nodes[i]];
        n[k] += 1;
    }
    forAll(sum, k)
    {
        reduce(sum[k], sumOp<vector>());
        sum[k] /= returnReduce(n[k], sumOp<scalar>());
    }
    return sum;
}


void Foam::rigidBodies::fit(const label b, const motionField& nodes)
{
    const body& at = bodies_[b];
    const bool flat = fe_.dim() == 2;
    const vector normal(flat ? rotation::axis(fe_.axis(2)) : vector::zero);

    // Axes from the first anchor to the others and normal to these, with rates
    struct rates { vector u, v, w; tensor axes() const { return tensor(u, v, w, true); } };
    const auto edges = [&](const List<vector>& x)
    {
        const vector u(x[1] - x[0]);
        return rates{u, flat ? normal ^ u : x[2] - x[0], normal};
    };
    const List<vector> D(atAnchors(at, nodes.D0)), v(atAnchors(at, nodes.v0)), a(atAnchors(at, nodes.a0));
    rates X(edges(at.anchors)), x(edges(D)), dx(edges(v)), ddx(edges(a));
    x.u += X.u;
    x.v += X.v;
    if (flat) dx.w = ddx.w = Zero;
    else
    {
        X.w = X.u ^ X.v;
        x.w = x.u ^ x.v;
        dx.w = (dx.u ^ x.v) + (x.u ^ dx.v);
        ddx.w = (ddx.u ^ x.v) + 2*(dx.u ^ dx.v) + (x.u ^ ddx.v);
    }
    const tensor inverse(inv(X.axes()));
    for (label k = 0; k < nPoints; ++k)
    {
        const label i = nPoints*b + k;
        const vector arm(k > 0 ? vector(at.size*rotation::axis(k - 1)) : vector::zero);
        const vector xi(inverse & (arm - at.anchors[0]));
        points_.D[i] = points_.D0[i] = at.anchors[0] + D[0] + (x.axes() & xi) - arm;
        points_.v[i] = points_.v0[i] = v[0] + (dx.axes() & xi);
        points_.a[i] = points_.a0[i] = a[0] + (ddx.axes() & xi);
    }
}


Foam::scalar Foam::rigidBodies::gap
(
    const label b,
    const vectorField& nodes,
    const vectorField& points
) const
{
    const body& at = bodies_[b];
    const vector& centre = points[nPoints*b];
    tensor slope = Zero;
    for (label k = 0; k < 3; ++k)
    {
        slope += (points[nPoints*b + 1 + k] - centre)*rotation::axis(k)/at.size;
    }
    scalar largest = 0;
    forAll(at.nodes, i)
    {
        largest = max(largest, mag(nodes[at.nodes[i]] - centre - (slope & at.arms[i])));
    }
    return returnReduce(largest, maxOp<scalar>());
}


bool Foam::rigidBodies::agrees
(
    const label b,
    const motionField& nodes,
    const scalar deltaT
) const
{
    // A speed at which a node stays where it is, is none
    scalar speed = 1e-3*bodies_[b].size/deltaT;
    for (const label n : bodies_[b].nodes) speed = max(speed, mag(nodes.v0[n]));
    reduce(speed, maxOp<scalar>());
    return
        gap(b, nodes.D0, points_.D0) <= 1e-6*bodies_[b].size
     && gap(b, nodes.v0, points_.v0) <= 1e-6*speed;
}


void Foam::rigidBodies::agree
(
    const label b,
    const motionField& nodes,
    const scalar deltaT
)
{
    if (agrees(b, nodes, deltaT)) return;
    fit(b, nodes);
    const tensor A(frame(points_.D0, b));
    const vector& D = points_.D0[nPoints*b];
    bool rigid = agrees(b, nodes, deltaT);
    for (label k = 0; k < 3; ++k)
    {
        // Lengths and angles are kept, too
        const vector arm(bodies_[b].size*rotation::axis(k));
        const vector off(points_.D0[nPoints*b + 1 + k] - D - ((A & arm) - arm));
        rigid = rigid && mag(off) <= 1e-6*bodies_[b].size;
    }
    if (rigid) return;
    FatalErrorInFunction
        << "The displacement or the velocity of rigidPatch " << bodies_[b].patch << " of region "
        << fe_.mesh().name() << " at time " << fe_.mesh().time().timeName()
        << " (pointD, pointV) is not that of a rigid body" << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rigidBodies::rigidBodies
(
    const feMesh& fe,
    const pointVectorField& pointD,
    const nodalBoundary& boundary,
    const label field,
    motionField& points
)
:
    fe_(fe),
    field_(field),
    points_(points),
    forceSize_(0),
    momentSize_(0)
{
    for (label a = 0; a < fe_.dim(); ++a) directions_.append(fe_.axis(a));
    if (fe_.dim() == 2) directions_.append(rigidSupport::ROTATION + fe_.axis(2));
    else for (label a = 0; a < 3; ++a) directions_.append(rigidSupport::ROTATION + fe_.axis(a));
    forAll(pointD.boundaryField(), patchi)
    {
        if (dynamic_cast<const rigidSupport*>(&pointD.boundaryField()[patchi]))
        {
            add(patchi, pointD, boundary);
        }
    }
    if (points_.size() != nPoints*size()) points_ = motionField(nPoints*size());
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::label Foam::rigidBodies::count(const pointVectorField& pointD)
{
    label n = 0;
    for (const auto& pf : pointD.boundaryField()) if (dynamic_cast<const rigidSupport*>(&pf)) ++n;
    return n;
}


Foam::List<Foam::fieldLayout::field> Foam::rigidBodies::fields
(
    const feMesh& fe,
    const label nBodies
)
{
    typedef fieldLayout layout;
    const layout::kind turns = fe.dim() == 2 ? layout::kind::SCALAR : layout::kind::VECTOR;
    return
    {
        layout::field("rigidTranslation", layout::kind::VECTOR, layout::support::BODIES, dimLength, nBodies),
        layout::field("rigidRotation", turns, layout::support::BODIES, dimless, nBodies)
    };
}


// ************************************************************************* //
