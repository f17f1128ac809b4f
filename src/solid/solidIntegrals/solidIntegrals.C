/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidIntegrals.H"
#include "enhancedKernel.H"
#include "materialLaw.H"
#include "shellKernel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Energy of the enhanced elements of a block
template<class E>
static scalar enhancedEnergy
(
    const feMesh& fe,
    const elementBlock& block,
    const materialLaw& law,
    const vectorField& D
)
{
    const FixedList<label, 3> axis({fe.axis(0), fe.axis(1), fe.axis(2)});
    enhancedKernel<pack, E, materialLaw> kernel(law);
    solidNodes<pack, E> n;
    scalar sum = 0;
    block.forBatches([&](const label batch)
    {
        gather<E, E::dim>(block, batch, fe.points(), axis, n.X);
        gather<E, E::dim>(block, batch, D, axis, n.D);
        const pack W = kernel.energy(n);
        for (int l = 0; l < block.nLanes(batch); ++l) sum += W[l];
    });
    return sum;
}


static scalar shellEnergy
(
    const feMesh& fe,
    const elementBlock& block,
    const solidMaterial& material,
    const vectorField& D
)
{
    shellKernel kernel(material);
    solidNodes<scalar, Hex1> n;
    scalar sum = 0;
    for (label e = 0; e < block.size(); ++e)
    {
        for (int i = 0; i < Hex1::nNodes; ++i) for (int a = 0; a < 3; ++a)
        {
            n.X[i][a] = fe.points()[block.element(e)[i]][fe.axis(a)];
            n.D[i][a] = D[block.element(e)[i]][fe.axis(a)];
        }
        sum += kernel.energy(n);
    }
    return sum;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidIntegrals::addMotion
(
    const feMesh& fe,
    const solidAssembly& assembly,
    const vector& g,
    const motionField& motion
)
{
    forAll(assembly.blocks(), b)
    {
        const elementBlock& block = assembly.blocks()[b];
        const scalar rho = assembly.material(b).rho();
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            feValues<scalar, E> w;
            Vec<scalar, E::dim> X[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                const label* nodes = block.element(e);
                for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                {
                    X[i][a] = fe.points()[nodes[i]][fe.axis(a)];
                }
                for (int q = 0; q < w.nQ; ++q)
                {
                    w.reinit(X, q);
                    vector D = Zero, v = Zero;
                    point x = Zero;
                    for (int i = 0; i < E::nNodes; ++i)
                    {
                        x += w.N[i]*fe.points()[nodes[i]];
                        D += w.N[i]*motion.D[nodes[i]];
                        v += w.N[i]*motion.v[nodes[i]];
                    }
                    x += D;
                    if (fe.dim() == 2) x[fe.axis(2)] = 0;
                    const scalar dm = rho*w.dV;
                    mass += dm;
                    kinetic += 0.5*magSqr(v)*dm;
                    weight -= (g & D)*dm;
                    momentum += dm*v;
                    angularMomentum += dm*(x ^ v);
                }
            }
        });
    }
}


void Foam::solidIntegrals::addStrain
(
    const feMesh& fe,
    const solidAssembly& assembly,
    const vectorField& D,
    const solidPoints& points
)
{
    points.atQuadrature
    (
        [&](auto, const label b, const label, const int, const scalar dV, const solidPoint& s)
        {
            if (!assembly.enhanced(b) && !assembly.shell()) strain += s.W*dV;
        }
    );
    forAll(assembly.blocks(), b)
    {
        const elementBlock& block = assembly.blocks()[b];
        const solidMaterial& material = assembly.material(b);
        if (assembly.shell()) strain += shellEnergy(fe, block, material, D);
        else if (!assembly.enhanced(b)) continue;
        else if (block.shape == elementShape::HEX)
        {
            strain += enhancedEnergy<Hex1>(fe, block, materialLaw(material), D);
        }
        else strain += enhancedEnergy<Quad1>(fe, block, materialLaw(material), D);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidIntegrals::solidIntegrals
(
    const feMesh& fe,
    const solidAssembly& assembly,
    const vector& g,
    const motionField& motion,
    const solidPoints& points
)
{
    addMotion(fe, assembly, g, motion);
    addStrain(fe, assembly, motion.D, points);
    for (scalar* s : {&mass, &kinetic, &strain, &weight}) reduce(*s, sumOp<scalar>());
    for (vector* v : {&momentum, &angularMomentum}) reduce(*v, sumOp<vector>());
}


// ************************************************************************* //
