/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidLoads.H"
#include "feValues.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Positions of an element's nodes in the directions of the case
template<int dim>
static void gatherElement
(
    const feMesh& fe,
    const elementBlock& block,
    const label e,
    const vectorField& f,
    Vec<double, dim>* v
)
{
    for (label i = 0; i < block.nNodes; ++i) for (int a = 0; a < dim; ++a)
    {
        v[i][a] = f[block.element(e)[i]][fe.axis(a)];
    }
}

//- Reference position of a quadrature point
static point position(const feMesh& fe, const elementBlock& block, const label e, const double* N)
{
    point X = Zero;
    for (label i = 0; i < block.nNodes; ++i) X += N[i]*fe.points()[block.element(e)[i]];
    return X;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class F>
void Foam::solidLoads::addTraction
(
    const elementBlock& block,
    const surfaceLoad& load,
    vectorField& force
) const
{
    faceValues<double, F> face;
    constexpr int dim = F::dim + 1;
    Vec<double, dim> X[F::nNodes];

    for (label e = 0; e < block.size(); ++e)
    {
        gatherElement<dim>(fe_, block, e, fe_.points(), X);
        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(X, q);
            const vector hdA =
                load.traction(position(fe_, block, e, face.N), time_)*::sqrt(face.ndA & face.ndA);
            for (int i = 0; i < F::nNodes; ++i) force[block.element(e)[i]] -= face.N[i]*hdA;
        }
    }
}


template<class F>
void Foam::solidLoads::addPressure
(
    const elementBlock& block,
    const surfaceLoad& load,
    vectorField& force,
    feMatrix* K
) const
{
    faceValues<double, F> face;
    constexpr int dim = F::dim + 1, nN = F::nNodes;
    Vec<double, dim> x[nN], D[nN];

    for (label e = 0; e < block.size(); ++e)
    {
        const label* n = block.element(e);
        gatherElement<dim>(fe_, block, e, stage_.X, x);
        gatherElement<dim>(fe_, block, e, stage_.D, D);
        for (int i = 0; i < nN; ++i) x[i] += D[i];

        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(x, q);
            const scalar pressure = load.pressure(position(fe_, block, e, face.N), time_);
            if (pressure == 0) continue;
            for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
            {
                force[n[i]][fe_.axis(a)] += face.N[i]*pressure*face.ndA[a];
            }
            if (!K) continue;

            for (int j = 0; j < nN; ++j) for (int b = 0; b < dim; ++b)
            {
                const Vec<double, dim> dA = (pressure*stage_.dDdu)*face.dArea(q, j, b);
                const label col = unknowns_.start(0, n[j]) + b;
                for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
                {
                    K->add(unknowns_.start(0, n[i]) + a, col, face.N[i]*dA[a]);
                }
            }
        }
    }
}


template<class F>
void Foam::solidLoads::addSupport
(
    const elementBlock& block,
    const surfaceSupport& support,
    const vectorField& velocity,
    const scalar dvdu,
    vectorField& force,
    feMatrix* K
) const
{
    atPoints<F>(block, support, velocity, [&](const auto& face, const label* n, const scalar dA, const auto& s)
    {
        for (int i = 0; i < F::nNodes; ++i) force[n[i]] -= (face.N[i]*dA)*s.traction;
        if (!K) return;

        const symmTensor dsdu(s.stiffness*stage_.dDdu + s.damping*dvdu);
        for (int i = 0; i < F::nNodes; ++i) for (int j = 0; j < F::nNodes; ++j)
        {
            const tensor k((face.N[i]*face.N[j]*dA)*dsdu);
            const label row = unknowns_.start(0, n[i]), col = unknowns_.start(0, n[j]);
            for (int a = 0; a < face.dim; ++a) for (int b = 0; b < face.dim; ++b)
            {
                K->add(row + a, col + b, k(fe_.axis(a), fe_.axis(b)));
            }
        }
    });
}


template<class F, class Function>
void Foam::solidLoads::atPoints
(
    const elementBlock& block,
    const surfaceSupport& support,
    const vectorField& velocity,
    const Function& f
) const
{
    faceValues<double, F> face;
    Vec<double, F::dim + 1> X[F::nNodes];

    for (label e = 0; e < block.size(); ++e)
    {
        const label* n = block.element(e);
        gatherElement<F::dim + 1>(fe_, block, e, fe_.points(), X);
        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(X, q);
            vector D = Zero, v = Zero;
            for (int i = 0; i < F::nNodes; ++i)
            {
                D += face.N[i]*stage_.D[n[i]];
                v += face.N[i]*velocity[n[i]];
            }
            const point at(position(fe_, block, e, face.N));
            f(face, n, ::sqrt(face.ndA & face.ndA), support.at(at, D, v, time_));
        }
    }
}


template<class Condition, class Function>
void Foam::solidLoads::forFaces(const label patchi, const Function& f) const
{
    const auto* condition = dynamic_cast<const Condition*>(&pointD_.boundaryField()[patchi]);
    if (!condition) return;
    for (const elementBlock& block : fe_.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto face)
        {
            if (face.dim + 1 == fe_.dim()) f(*condition, block, face);
        });
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidLoads::addSurface(vectorField& force, feMatrix* K) const
{
    forAll(pointD_.boundaryField(), patchi)
    {
        forFaces<surfaceLoad>(patchi, [&](const surfaceLoad& load, const elementBlock& block, auto face)
        {
            addTraction<decltype(face)>(block, load, force);
            addPressure<decltype(face)>(block, load, force, K);
        });
    }
}


void Foam::solidLoads::addSupports
(
    const labelUList& patches,
    const vectorField& v,
    const scalar dvdu,
    vectorField& force,
    feMatrix* K
) const
{
    for (const label patchi : patches)
    {
        forFaces<surfaceSupport>(patchi, [&](const surfaceSupport& support, const elementBlock& block, auto face)
        {
            addSupport<decltype(face)>(block, support, v, dvdu, force, K);
        });
    }
}


Foam::supportTotals Foam::solidLoads::supportOf(const label patchi, const vectorField& v) const
{
    supportTotals sum;
    forFaces<surfaceSupport>(patchi, [&](const surfaceSupport& support, const elementBlock& block, auto tag)
    {
        atPoints<decltype(tag)>
        (
            block, support, v,
            [&](const auto&, const label*, const scalar dA, const surfaceSupport::reaction& s)
            {
                sum.force += s.traction*dA;
                sum.area += (mag(s.traction) > 0)*dA;
                sum.traction = max(sum.traction, mag(s.traction));
                sum.gap = min(sum.gap, s.gap);
            }
        );
    });
    return sum;
}


// ************************************************************************* //
