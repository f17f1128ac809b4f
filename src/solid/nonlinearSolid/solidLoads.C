/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidLoads.H"
#include "feValues.H"
#include "surfaceSupport.H"

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
    const scalar t,
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
                load.traction(position(fe_, block, e, face.N), t)*::sqrt(face.ndA & face.ndA);
            for (int i = 0; i < F::nNodes; ++i) force[block.element(e)[i]] -= face.N[i]*hdA;
        }
    }
}


template<class F>
void Foam::solidLoads::addPressure
(
    const elementBlock& block,
    const solidStage& stage,
    const surfaceLoad& load,
    const scalar t,
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
        gatherElement<dim>(fe_, block, e, stage.X, x);
        gatherElement<dim>(fe_, block, e, stage.D, D);
        for (int i = 0; i < nN; ++i) x[i] += D[i];

        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(x, q);
            const scalar pressure = load.pressure(position(fe_, block, e, face.N), t);
            if (pressure == 0) continue;
            for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
            {
                force[n[i]][fe_.axis(a)] += face.N[i]*pressure*face.ndA[a];
            }
            if (!K) continue;

            for (int j = 0; j < nN; ++j) for (int b = 0; b < dim; ++b)
            {
                const Vec<double, dim> dA = (pressure*stage.dDdu)*face.dArea(q, j, b);
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
void Foam::solidLoads::addSprings
(
    const elementBlock& block,
    const vectorField& s,
    const symmTensor& dsdu,
    vectorField& force,
    feMatrix* K
) const
{
    faceValues<double, F> face;
    constexpr int dim = F::dim + 1, nN = F::nNodes;
    Vec<double, dim> X[nN];

    for (label e = 0; e < block.size(); ++e)
    {
        const label* n = block.element(e);
        gatherElement<dim>(fe_, block, e, fe_.points(), X);
        for (int q = 0; q < face.nQ; ++q)
        {
            face.reinit(X, q);
            const scalar dA = ::sqrt(face.ndA & face.ndA);
            vector sq = Zero;
            for (int i = 0; i < nN; ++i) sq += face.N[i]*s[n[i]];
            for (int i = 0; i < nN; ++i) force[n[i]] += (face.N[i]*dA)*sq;
            if (!K) continue;

            for (int i = 0; i < nN; ++i) for (int j = 0; j < nN; ++j)
            {
                const symmTensor k((face.N[i]*face.N[j]*dA)*dsdu);
                const label row = unknowns_.start(0, n[i]), col = unknowns_.start(0, n[j]);
                for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
                {
                    K->add(row + a, col + b, tensor(k)(fe_.axis(a), fe_.axis(b)));
                }
            }
        }
    }
}


template<class Condition, class F>
void Foam::solidLoads::forFaces(const pointVectorField& pointD, const F& f) const
{
    forAll(pointD.boundaryField(), patchi)
    {
        const auto* condition = dynamic_cast<const Condition*>(&pointD.boundaryField()[patchi]);
        if (!condition) continue;
        for (const elementBlock& block : fe_.patchBlocks(patchi))
        {
            withFaceElement(block, [&](auto face)
            {
                if (face.dim + 1 == fe_.dim()) f(*condition, block, face);
            });
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidLoads::addSurface
(
    const pointVectorField& pointD,
    const solidStage& stage,
    const scalar t,
    vectorField& force,
    feMatrix* K
) const
{
    forFaces<surfaceLoad>(pointD, [&](const surfaceLoad& load, const elementBlock& block, auto face)
    {
        addTraction<decltype(face)>(block, load, t, force);
        addPressure<decltype(face)>(block, stage, load, t, force, K);
    });
}


void Foam::solidLoads::addSupports
(
    const pointVectorField& pointD,
    const solidStage& stage,
    const vectorField& v,
    const scalar dvdu,
    vectorField& force,
    feMatrix* K
) const
{
    forFaces<surfaceSupport>(pointD, [&](const surfaceSupport& support, const elementBlock& block, auto face)
    {
        const symmTensor &k = support.stiffness(), &c = support.damping();
        const vectorField s((k & stage.D) + (c & v));
        addSprings<decltype(face)>(block, s, symmTensor(k*stage.dDdu + c*dvdu), force, K);
    });
}


// ************************************************************************* //
