/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowLoads.H"
#include "feValues.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::flowLoads::readPressures()
{
    if (pressurePatches_.empty()) return;
    pointP_.correctBoundaryConditions();

    // Mid-side nodes take the mean of their ends
    for (const label patchi : pressurePatches_)
    {
        const auto& pf = refCast<const valuePointPatchField<scalar>>(pointP_.boundaryField()[patchi]);
        const labelList& points = pf.patch().meshPoints();
        forAll(points, i) p_.v[fe_.pointNode()[points[i]]] = pf[i];
        for (const elementBlock& block : fe_.patchBlocks(patchi)) for (const label n : block.nodes)
        {
            if (n < fe_.nVertices()) continue;
            p_.v[n] = 0;
            for (const label m : fe_.parents()[n]) p_.v[n] += p_.v[m]/fe_.parents()[n].size();
        }
    }
}


template<int dim>
struct Foam::flowLoads::openLoad
{
    typedef Vec<double, dim> vec;
    typedef Ten<double, dim> ten;

    //- n is n dA; beta times the density; in: density where p is total and c.n < 0
    const vec t, n, u, c;
    const double p, beta, Z, total;
    const double dA = ::sqrt(n & n), out = c & n, cn = min(out, 0.0), in = cn < 0 ? total : 0;
    const double normal = p - 0.5*in*(u & u) + Z*out/dA;

    //- h = t - (p - in |v|^2/2 + Z c.n) n + beta rho min(c.n, 0) v
    vec h() const { return dA*t - normal*n + (beta*cn)*u; }

    bool hasVelocity() const { return cn < 0 || Z > 0; }

    ten byVelocity() const
    {
        ten dh = in*(n*u) + (-Z/dA)*(n*n);
        if (cn < 0) dh += beta*(cn*ten::I() + u*n);
        return dh;
    }

    //- By a change dn of n dA and one of c that is the mesh's
    vec byGeometry(const vec& dn, const vec& dc) const
    {
        const double dOut = (dc & n) + (c & dn), ddA = (n & dn)/dA;
        vec dh = ddA*t - normal*dn - (Z*(dOut - out*ddA/dA)/dA)*n;
        if (cn < 0) dh += (beta*dOut)*u;
        return dh;
    }
};


template<class F, class Traction, class Pressure>
void Foam::flowLoads::addOpen
(
    const elementBlock& block,
    const Traction& traction,
    const Pressure& pressure,
    const surfaceLoad::answer& answer,
    const job& j
) const
{
    constexpr int dim = F::dim + 1;
    typedef Vec<double, dim> vec;
    faceValues<double, F> face;

    const auto inPlane = [&](const vector& u)
    {
        vec v;
        for (int a = 0; a < dim; ++a) v[a] = u[fe_.axis(a)];
        return v;
    };
    const auto add = [&](feMatrix& K, const fieldUnknowns& columns, const label row, const label col, const auto& dh)
    {
        const label r = j.unknowns.start(0, row), c = columns.start(0, col);
        for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b) K.add(r + a, c + b, -j.columns*dh(a, b));
    };

    for (label e = 0; e < block.size(); ++e)
    {
        const label* nodes = block.element(e);
        vec x[F::nNodes], v[F::nNodes], c[F::nNodes];
        const auto at = [&](const auto& f)
        {
            auto s = face.N[0]*f[nodes[0]];
            for (int i = 1; i < F::nNodes; ++i) s += face.N[i]*f[nodes[i]];
            return s;
        };
        for (int i = 0; i < F::nNodes; ++i)
        {
            x[i] = inPlane(j.stage.x[nodes[i]]);
            v[i] = inPlane(j.stage.v[nodes[i]]);
            c[i] = v[i] - inPlane(j.stage.vm[nodes[i]]);
        }
        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(x, q);
            const openLoad<dim> load
            {
                inPlane(traction(at)), face.ndA, face.value(v), face.value(c), pressure(at),
                answer.backflow*j.rho, answer.impedance, answer.total ? j.rho : 0
            };
            const vec h = load.h();
            for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < dim; ++a)
            {
                j.force[nodes[i]][fe_.axis(a)] -= face.N[i]*h[a];
            }
            if (j.K && load.hasVelocity())
            {
                const Ten<double, dim> dh = load.byVelocity();
                for (int i = 0; i < F::nNodes; ++i) for (int l = 0; l < F::nNodes; ++l)
                {
                    add(*j.K, j.unknowns, nodes[i], nodes[l], face.N[i]*face.N[l]*dh);
                }
            }
            if (!j.S) continue;
            for (int l = 0; l < F::nNodes; ++l)
            {
                Ten<double, dim> dh;
                for (int b = 0; b < dim; ++b)
                {
                    vec dc = vec::zero();
                    dc[b] = -j.dvmdm*face.N[l];
                    const vec column = load.byGeometry(face.dArea(q, l, b), dc);
                    for (int a = 0; a < dim; ++a) dh(a, b) = column[a];
                }
                for (int i = 0; i < F::nNodes; ++i) add(*j.S, *j.positions, nodes[i], nodes[l], face.N[i]*dh);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowLoads::flowLoads
(
    const feMesh& fe,
    const pointVectorField& pointU,
    pointScalarField& pointP,
    rateField<scalar>& prescribed,
    const bool first
)
:
    fe_(fe),
    pointU_(pointU),
    pointP_(pointP),
    p_(prescribed)
{
    forAll(pointP.boundaryField(), patchi)
    {
        const auto& p = pointP.boundaryField()[patchi];
        const auto& u = pointU.boundaryField()[patchi];
        if (!isA<valuePointPatchField<scalar>>(p)) continue;
        if (dynamic_cast<const surfaceLoad*>(&u) || !isOpen(u))
        {
            FatalErrorInFunction
                << "Patch " << p.patch().name() << ": " << pointP.objectPath()
                << " gives the pressure (" << p.type() << "), and " << pointU.objectPath()
                << " is of type " << u.type() << ", which "
                << (
                       dynamic_cast<const surfaceLoad*>(&u)
                     ? "gives the load there, too"
                     : "gives the velocity there, too"
                   )
                << '.' << nl
                << "Expected type zeroGradient in pointP; or a pressure boundary: its values"
                << " in pointP and type zeroGradient (or fixedComponents, of tangential"
                << " directions) in pointU, or type openBoundary with the entry pressure in"
                << " pointU" << exit(FatalError);
        }
        if (first) Info<< "Patch " << p.patch().name() << " of region " << fe.mesh().name()
            << " is a pressure boundary: values of pointP, backflow stabilisation " << backflow(patchi) << nl;
        pressurePatches_.append(patchi);
    }
    if (!first || pressurePatches_.empty()) return;
    p_ = rateField<scalar>(fe.nNodes());
    readPressures();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::flowLoads::backflow(const label patchi) const
{
    const auto* given = dynamic_cast<const nodalComponents*>(&pointU_.boundaryField()[patchi]);
    return given ? given->backflow() : 0.5;
}


bool Foam::flowLoads::isOpen(const pointPatchVectorField& pf)
{
    return nodalBoundary::isNatural(pf) || dynamic_cast<const nodalComponents*>(&pf);
}


template<class Traction, class Pressure>
void Foam::flowLoads::addBlocks
(
    const label patchi,
    const Traction& traction,
    const Pressure& pressure,
    const surfaceLoad::answer& answer,
    const job& j
) const
{
    for (const elementBlock& block : fe_.patchBlocks(patchi)) withFaceElement(block, [&](auto F)
    {
        if (F.dim == fe_.dim() - 1) addOpen<decltype(F)>(block, traction, pressure, answer, j);
    });
}


bool Foam::flowLoads::addPatch(const label patchi, const job& j) const
{
    if (const auto* load = dynamic_cast<const surfaceLoad*>(&pointU_.boundaryField()[patchi]))
    {
        addBlocks
        (
            patchi,
            [&](const auto& at) { return load->traction(at(j.stage.x), j.stageTime); },
            [&](const auto& at) { return load->pressure(at(j.stage.x), j.stageTime); },
            load->toFlow(),
            j
        );
        return true;
    }
    if (!pressurePatches_.found(patchi)) return false;
    surfaceLoad::answer bounded;
    bounded.backflow = backflow(patchi);
    const scalarField &p = p_.v, &p0 = p_.v0;
    addBlocks
    (
        patchi,
        [](const auto&) { return vector::zero; },
        [&](const auto& at) { return at(p0) + j.columns*(at(p) - at(p0)); },
        bounded,
        j
    );
    return true;
}


void Foam::flowLoads::addSurface(const job& j) const
{
    forAll(pointU_.boundaryField(), patchi) addPatch(patchi, j);
}


// ************************************************************************* //
