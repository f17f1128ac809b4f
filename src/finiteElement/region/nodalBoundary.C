/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalBoundary.H"
#include "nodalSurface.H"
#include "feValues.H"
#include "calculatedPointPatchField.H"
#include "zeroGradientPointPatchField.H"
#include "basicSymmetryPointPatchField.H"
#include "symmetryPointPatchField.H"
#include "symmetryPlanePointPatchField.H"
#include "slipPointPatchField.H"
#include "fixedNormalSlipPointPatchField.H"
#include "wedgePointPatchField.H"
#include "cyclicPointPatchField.H"
#include "emptyPointPatchField.H"
#include "processorPointPatchField.H"
#include "processorCyclicPointPatchField.H"
#include "IStringStream.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The patch's condition is of one of these classes itself, not of a derived
//  one that may mean something else
template<class... Classes, class Patch>
static bool isOneOf(const Patch& pf)
{
    return (... || (typeid(pf) == typeid(Classes)));
}


//- Normal of a fixedNormalSlip, which keeps it to itself
static vector givenNormal(const pointPatchVectorField& pf)
{
    OStringStream os;
    pf.write(os);
    IStringStream is(os.str());
    const vector n(dictionary(is).get<vector>("n"));
    if (mag(n) < VSMALL)
    {
        FatalErrorInFunction
            << "Patch " << pf.patch().name() << " of type " << pf.type()
            << " has the normal " << n << ", expected one that is not nil"
            << exit(FatalError);
    }
    return n/mag(n);
}


//- The direction of a plane that is a surface's
static const label ON_SURFACE = -2;


//- Displacement of a node that the field has
static vector displacement(const pointVectorField& field, const feMesh& fe, const label node)
{
    if (node < fe.nVertices()) return field[fe.vertexPoint()[node]];
    vector u = Zero;
    const labelList& ends = fe.parents()[node];
    for (const label m : ends) u += field[fe.vertexPoint()[m]]/scalar(ends.size());
    return u;
}


//- An error if the nodes of a patch are not on the surface on which they are
//  to slide: further away than a hundredth of the patch's extent
static void checkPlaces
(
    const pointPatchVectorField& pf,
    const nodalSurface& surface,
    const vectorField& nodes
)
{
    const scalar extent = boundBox(nodes).mag();
    scalar worst = 0;
    point place = Zero;
    for (const point& x : nodes)
    {
        const scalar gap = mag(surface.placeOf(x).gap);
        if (gap <= worst) continue;
        worst = gap;
        place = x;
    }
    if (returnReduce(worst, maxOp<scalar>()) <= 0.01*extent) return;
    FatalErrorInFunction
        << "Patch " << pf.patch().name() << " of type " << pf.type() << " has a point at " << place
        << " that is " << worst << " m from the surface, of a patch that extends over " << extent
        << " m: give the surface of the mesh" << exit(FatalError);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::nodalBoundary::normals(const label patchi) const
{
    tmp<vectorField> tn(new vectorField(fe_.nNodes(), Zero));
    vectorField& n = tn.ref();

    for (const elementBlock& block : fe_.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto tag)
        {
            typedef decltype(tag) F;
            faceValues<double, F> face;
            Vec<double, face.dim> x[F::nNodes];
            if (face.dim != fe_.dim()) return;
            for (label e = 0; e < block.size(); ++e)
            {
                const label* nodes = block.element(e);
                for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < face.dim; ++a)
                {
                    x[i][a] = fe_.points()[nodes[i]][fe_.axis(a)];
                }
                for (int q = 0; q < face.nQ; ++q)
                {
                    face.reinit(x, q);
                    for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < face.dim; ++a)
                    {
                        // Of all faces at the node alike: vertices of order 2
                        // have shape functions of mean zero on triangles
                        n[nodes[i]][fe_.axis(a)] += face.ndA[a];
                    }
                }
            }
        });
    }

    // The copies of a node see different faces
    if (Pstream::parRun()) for (label a = 0; a < fe_.dim(); ++a)
    {
        scalarField na(n.component(fe_.axis(a)));
        fe_.copies().sum(na);
        forAll(n, i) n[i][fe_.axis(a)] = na[i];
    }
    return tn;
}


void Foam::nodalBoundary::addPlanes(const label patchi)
{
    const pointPatchVectorField& pf = field_.boundaryField()[patchi];
    const labelList& nodes = fe_.patchNodes(patchi);

    if (const auto* given = dynamic_cast<const nodalComponents*>(&pf))
    {
        for (const label i : nodes) forAll(given->directions(), d)
        {
            planes_(i).append({given->directions()[d], patchi, d});
        }
    }
    else if (const auto* surface = dynamic_cast<const nodalSurface*>(&pf))
    {
        checkPlaces(pf, *surface, vectorField(fe_.points(), nodes));
        for (const label i : nodes)
        {
            planes_(i).append({surface->placeOf(fe_.points()[i]).normal, patchi, ON_SURFACE});
        }
    }
    else if (isA<fixedNormalSlipPointPatchField<vector>>(pf))
    {
        const vector n(givenNormal(pf));
        for (const label i : nodes) planes_(i).append({n, patchi, -1});
    }
    else if (isSliding(pf))
    {
        const vectorField n(normals(patchi));
        for (const label i : nodes)
        {
            if (mag(n[i]) > VSMALL) planes_(i).append({n[i]/mag(n[i]), patchi, -1});
        }
    }
}


void Foam::nodalBoundary::addProfiles()
{
    forAll(field_.boundaryField(), patchi)
    {
        const auto* flow = dynamic_cast<const nodalFlow*>(&field_.boundaryField()[patchi]);
        if (!flow) continue;

        // A flat profile leaves nodes to patches that come later, a developed one
        // to all others
        boolList others(fe_.nNodes(), false);
        for (const label n : fe_.patchNodes(patchi)) others[n] = patchOf_[n] != patchi + 1;
        if (flow->developed()) forAll(field_.boundaryField(), patchj)
        {
            if (patchj == patchi || !isA<valuePointPatchField<vector>>(field_.boundaryField()[patchj])) continue;
            for (const label n : fe_.patchNodes(patchj)) others[n] = true;
        }
        profiles_.set
        (
            patchi,
            new patchProfile(fe_, patchi, normals(patchi), others, flow->developed())
        );
    }
}


void Foam::nodalBoundary::checkNumber(const label node, const vector& value, const scalar t) const
{
    if (std::isfinite(mag(value))) return;
    FatalErrorInFunction
        << "Field " << field_.name() << " of region " << fe_.mesh().name() << " has the value " << value
        << " on patch " << patchName(node) << " at " << position(node) << " at time " << t
        << ", expected finite numbers: see the functions of that patch" << exit(FatalError);
}


Foam::nodalBoundary::frame Foam::nodalBoundary::frameAt
(
    const label node,
    const scalar t
) const
{
    frame f;
    for (const plane& p : planes_[node])
    {
        vector n = p.n;
        scalar value = 0;
        const auto& pf = field_.boundaryField()[p.patch];
        if (p.direction >= 0)
        {
            value = dynamic_cast<const nodalComponents&>(pf)
                .component(p.direction, position(node), t);
        }
        else if (p.direction == ON_SURFACE)
        {
            const auto& surface = dynamic_cast<const nodalSurface&>(pf);
            const vector u(displacement(field_, fe_, node));
            const nodalSurface::place now = surface.placeOf(fe_.points()[node] + u);
            n = now.normal;
            value = (n & u) - now.gap + surface.placeOf(fe_.points()[node]).gap;
        }
        if (fe_.dim() == 2) n[fe_.axis(2)] = 0;
        const vector given(n);
        forAll(f.n, k)
        {
            const scalar along = given & f.n[k];
            n -= along*f.n[k];
            value -= along*f.value[k];
        }
        if (mag(n) < 1e-3) continue;
        f.n.append(n/mag(n));
        f.value.append(value/mag(n));
    }
    return f;
}


void Foam::nodalBoundary::constrainPlanes
(
    const label node,
    const fieldUnknowns& unknowns,
    const label f,
    dofConstraints& c
) const
{
    typedef dofConstraints::term term;
    const label dim = fe_.dim(), start = unknowns.start(f, node);
    const frame at(frameAt(node, fe_.mesh().time().timeOutputValue()));

    const auto cmpt = [&](const vector& v, const label a) { return v[fe_.axis(a)]; };
    const auto largest = [&](const vector& v)
    {
        // The first of components that are alike to round-off, on any rank
        label k = 0;
        for (label a = 1; a < dim; ++a) if (mag(cmpt(v, a)) > (1 + 1e-6)*mag(cmpt(v, k))) k = a;
        return k;
    };
    if (at.n.size() >= dim)
    {
        for (label a = 0; a < dim; ++a)
        {
            scalar b = 0;
            forAll(at.n, k) b += at.value[k]*cmpt(at.n[k], a);
            c.tie(start + a, List<term>(), b);
        }
    }
    else if (at.n.size() == 1)
    {
        // u_k = (g - sum_a n_a u_a)/n_k
        const vector& n = at.n[0];
        const label k = largest(n);
        DynamicList<term> row;
        for (label a = 0; a < dim; ++a)
        {
            const scalar w = -cmpt(n, a)/cmpt(n, k);
            if (a != k && mag(w) > 1e-10) row.append({start + a, w});
        }
        c.tie(start + k, row, at.value[0]/cmpt(n, k));
    }
    else
    {
        // On the line of two planes, u = u0 + s t: u_a = u0_a + t_a (u_k - u0_k)/t_k
        const vector t = at.n[0] ^ at.n[1];
        const vector u0 = at.value[0]*at.n[0] + at.value[1]*at.n[1];
        const label k = largest(t);
        for (label a = 0; a < dim; ++a)
        {
            if (a == k) continue;
            const scalar w = cmpt(t, a)/cmpt(t, k);
            DynamicList<term> row;
            if (mag(w) > 1e-10) row.append({start + k, w});
            c.tie(start + a, row, cmpt(u0, a) - w*cmpt(u0, k));
        }
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

template<class Type>
bool Foam::nodalBoundary::isNatural(const pointPatchField<Type>& pf)
{
    // What a calculated patch of ours means is its own matter
    return
        dynamic_cast<const surfaceLoad*>(&pf)
     || isOneOf<calculatedPointPatchField<Type>, zeroGradientPointPatchField<Type>>(pf);
}


bool Foam::nodalBoundary::isSliding(const pointPatchVectorField& pf)
{
    return isOneOf
    <
        slipPointPatchField<vector>, symmetryPointPatchField<vector>,
        symmetryPlanePointPatchField<vector>, wedgePointPatchField<vector>,
        fixedNormalSlipPointPatchField<vector>
    >(pf);
}


bool Foam::nodalBoundary::constrains(const pointPatchVectorField& pf)
{
    return
        isA<valuePointPatchField<vector>>(pf) || isSliding(pf)
     || dynamic_cast<const nodalComponents*>(&pf) || dynamic_cast<const nodalSurface*>(&pf);
}


template<class Type>
void Foam::nodalBoundary::check
(
    const GeometricField<Type, pointPatchField, pointMesh>& field
)
{
    for (const pointPatchField<Type>& pf : field.boundaryField())
    {
        const bool constraint = isOneOf
        <
            emptyPointPatchField<Type>, processorPointPatchField<Type>,
            processorCyclicPointPatchField<Type>, cyclicPointPatchField<Type>,
            symmetryPointPatchField<Type>, symmetryPlanePointPatchField<Type>,
            wedgePointPatchField<Type>
        >(pf);
        const bool vectorOnly =
            std::is_same<Type, vector>::value
         && (
                isOneOf<slipPointPatchField<Type>, fixedNormalSlipPointPatchField<Type>>(pf)
             || dynamic_cast<const nodalComponents*>(&pf)
             || dynamic_cast<const nodalSurface*>(&pf)
            );
        if (constraint || vectorOnly || isNatural(pf) || isA<valuePointPatchField<Type>>(pf)) continue;

        FatalErrorInFunction
            << "Patch " << pf.patch().name() << " of field " << field.objectPath()
            << " is of type " << pf.type() << ", which is not understood here: it"
            << " would be a free boundary in silence." << nl
            << "Understood are types with values (fixedValue, uniformFixedValue,"
            << " nodalProfile, flowRateInlet, ...), slip, surfaceSlip, fixedNormalSlip, fixedComponents,"
            << " symmetry, symmetryPlane, wedge, cyclic, empty; for free boundaries"
            << " calculated, zeroGradient, and the loads openBoundary, traction,"
            << " followerPressure, springs; in a solid rigidContact, rigidPatch" << exit(FatalError);
    }
}


namespace Foam
{
    template bool nodalBoundary::isNatural(const pointPatchField<scalar>&);
    template bool nodalBoundary::isNatural(const pointPatchField<vector>&);
    template void nodalBoundary::check(const pointScalarField&);
    template void nodalBoundary::check(const pointVectorField&);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodalBoundary::nodalBoundary(const feMesh& fe, pointVectorField& field)
:
    fe_(fe),
    field_(field),
    cyclic_(fe),
    patchOf_(fe.nNodes(), 0)
{
    check(field);
    forAll(field.boundaryField(), patchi)
    {
        if (isA<valuePointPatchField<vector>>(field.boundaryField()[patchi]))
        {
            for (const label n : fe.patchNodes(patchi)) patchOf_[n] = patchi + 1;
        }
        else
        {
            addPlanes(patchi);
        }
    }
    addProfiles();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nodalBoundary::constrain
(
    const fieldUnknowns& unknowns,
    const label f,
    dofConstraints& c,
    const labelHashSet& leftOut
) const
{
    for (const label n : planes_.sortedToc()) constrainPlanes(n, unknowns, f, c);
    cyclic_.tie(unknowns, f, c);
    forAll(patchOf_, n)
    {
        if (!patchOf_[n] || leftOut.found(n)) continue;
        for (label a = 0; a < fe_.dim(); ++a) c.fix(unknowns.start(f, n) + a);
    }
}


bool Foam::nodalBoundary::project
(
    vectorField& u,
    const scalar t,
    const bool homogeneous
) const
{
    bool changed = false;
    forAllConstIters(planes_, iter)
    {
        const label i = iter.key();
        if (patchOf_[i]) continue;
        const frame at(frameAt(i, t));
        forAll(at.n, k)
        {
            const scalar g = homogeneous ? 0 : at.value[k];
            const scalar excess = (at.n[k] & u[i]) - g;
            if (mag(excess) <= 1e-13*(mag(u[i]) + mag(g))) continue;
            u[i] -= excess*at.n[k];
            changed = true;
        }
    }

    // Partners of cyclic patches, without an exchange where there are none
    return cyclic_.follow(u) || changed;
}


Foam::List<Foam::vector> Foam::nodalBoundary::givenDirections(const label node) const
{
    if (!planes_.found(node)) return List<vector>();
    return List<vector>(frameAt(node, fe_.mesh().time().timeOutputValue()).n);
}


Foam::word Foam::nodalBoundary::patchName(const label node) const
{
    const label patchi = patchOf_[node] ? patchOf_[node] - 1 : planes_[node][0].patch;
    return fe_.mesh().boundaryMesh()[patchi].name();
}


// ************************************************************************* //
