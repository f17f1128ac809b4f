/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchProfile.H"
#include "patchIntegrals.H"
#include "feValues.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class F>
void Foam::patchProfile::forPoints(const F& f) const
{
    for (const elementBlock& block : fe_.patchBlocks(patchi_)) withFaceElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        constexpr int dim = E::dim + 1;
        if (dim != fe_.dim()) return;
        faceValues<double, E> face;
        Vec<double, dim> x[E::nNodes];
        for (label e = 0; e < block.size(); ++e)
        {
            for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < dim; ++a)
            {
                x[i][a] = fe_.points()[block.element(e)[i]][fe_.axis(a)];
            }
            for (int q = 0; q < face.nQ; ++q)
            {
                face.reinit(x, q);
                f(block.element(e), face, q, ::sqrt(face.ndA & face.ndA));
            }
        }
    });
}


void Foam::patchProfile::multiply(const scalarField& phi, scalarField& A) const
{
    A = 0;
    forPoints([&](const label* nodes, const auto& face, const int q, const scalar dA)
    {
        // grad N.grad M = dN g^-1 dM with the metric g of the tangents
        constexpr int d = std::decay_t<decltype(face)>::dim - 1, n = std::decay_t<decltype(face)>::n;
        double g[2][2] = {{1, 0}, {0, 1}}, s[2] = {0, 0};
        for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b) g[a][b] = face.t[a] & face.t[b];
        const double detG = g[0][0]*g[1][1] - g[0][1]*g[1][0];
        for (int i = 0; i < n; ++i) for (int a = 0; a < d; ++a) s[a] += phi[nodes[i]]*face.ref.dN[q][i][a];
        const double flux[2] =
            {(g[1][1]*s[0] - g[0][1]*s[1])/detG, (g[0][0]*s[1] - g[1][0]*s[0])/detG};
        for (int i = 0; i < n; ++i) for (int a = 0; a < d; ++a)
        {
            A[nodes[i]] += face.ref.dN[q][i][a]*flux[a]*dA;
        }
    });
    fe_.copies().sum(A);
}


void Foam::patchProfile::addAreas(scalarField& b) const
{
    forPoints([&](const label* nodes, const auto& face, const int, const scalar dA)
    {
        for (int i = 0; i < face.n; ++i) b[nodes[i]] += face.N[i]*dA;
    });
    fe_.copies().sum(b);
}


void Foam::patchProfile::develop(const boolList& rim, scalarField& phi) const
{
    const nodeMap& copies = fe_.copies();
    const auto atRim = [&](scalarField& x) { forAll(rim, n) if (rim[n]) x[n] = 0; };

    // Without a rim all is as far from it as anything else
    label nRim = 0;
    for (const label n : fe_.patchNodes(patchi_)) nRim += rim[n];
    if (!returnReduce(nRim, sumOp<label>())) return;

    scalarField r(phi.size(), 0), Ap(phi.size());
    phi = 0;
    addAreas(r);
    atRim(r);
    scalarField p(r);
    scalar rr = copies.dot(r, r);
    const scalar enough = 1e-28*rr;
    const label most = 10*returnReduce(fe_.patchNodes(patchi_).size(), sumOp<label>());
    for (label i = 0; i < most && rr > enough; ++i)
    {
        multiply(p, Ap);
        atRim(Ap);
        const scalar pAp = copies.dot(p, Ap);
        if (!(pAp > 0)) break;
        phi += (rr/pAp)*p;
        r -= (rr/pAp)*Ap;
        const scalar next = copies.dot(r, r);
        p = r + (next/rr)*p;
        rr = next;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchProfile::patchProfile
(
    const feMesh& fe,
    const label patchi,
    const vectorField& normals,
    const boolList& others,
    const bool developed
)
:
    fe_(fe),
    patchi_(patchi),
    v_(fe.nNodes(), Zero)
{
    scalarField phi(fe.nNodes(), 1);
    if (developed) develop(others, phi);
    for (const label n : fe.patchNodes(patchi))
    {
        if (!others[n] && mag(normals[n]) > VSMALL) v_[n] = (-phi[n]/mag(normals[n]))*normals[n];
    }

    const scalarField none(fe.nNodes(), 0);
    const patchIntegrals at(fe, labelList({patchi}), fe.points(), v_, none);
    if (!(at.flux < -1e-10*max(at.magFlux, VSMALL)) || !std::isfinite(at.flux))
    {
        FatalErrorInFunction
            << "Patch " << fe.mesh().boundaryMesh()[patchi].name() << " of region "
            << fe.mesh().name() << " has a flow rate, but no node of its own that could carry it:"
            << " other patches give the velocity at all of them. Expected a patch of two elements across at least" << exit(FatalError);
    }
    v_ /= -at.flux;
}


// ************************************************************************* //
