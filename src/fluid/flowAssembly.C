/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAssembly.H"
#include "eddyViscosity.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::flowAssembly::assemble
(
    const flowParameters& k,
    const flowFields& fields,
    vectorField& Ru,
    scalarField& Rp,
    flowMatrices* matrices
) const
{
    job j{k, fields, Ru, Rp, matrices};
    const bool general = k.general();
    switch (k.family)
    {
        case flowFamily::EQUAL_ORDER:
            general
          ? assembleBlocks<flowFamily::EQUAL_ORDER, true, true>(j)
          : assembleBlocks<flowFamily::EQUAL_ORDER, true, false>(j);
            break;
        case flowFamily::TAYLOR_HOOD:
            general ? assembleBlocks<flowFamily::TAYLOR_HOOD, true, true>(j)
          : k.stabilised ? assembleBlocks<flowFamily::TAYLOR_HOOD, true, false>(j)
          : assembleBlocks<flowFamily::TAYLOR_HOOD, false, false>(j);
            break;
        case flowFamily::Q1Q0:
            general
          ? assembleBlocks<flowFamily::Q1Q0, true, true>(j)
          : assembleBlocks<flowFamily::Q1Q0, true, false>(j);
            break;
    }
    return j.minDetJ;
}


Foam::label Foam::flowAssembly::nPoints() const
{
    label n = 0;
    for (const elementBlock& block : fe_.blocks())
    {
        withElement(block, [&](auto tag) { n = max(n, label(feValues<double, decltype(tag)>::nQ)); });
    }
    return returnReduce(n, maxOp<label>());
}


void Foam::flowAssembly::eddyViscosity
(
    const flowParameters& p,
    const flowFields& fields,
    scalarField& nut
) const
{
    for (const elementBlock& block : fe_.blocks()) withElement(block, [&](auto tag)
    {
        typedef decltype(tag) V;
        constexpr int dim = V::dim;
        if (dim != fe_.dim()) return;
        flowConstants<dim> k;
        k.eddy = p.eddy;
        k.C2 = sqr(p.eddyConstant);
        k.damped = p.damped;
        feValues<double, V> w;
        Foam::eddyViscosity<double, V> eddy;
        Vec<double, dim> x[V::nNodes], v[V::nNodes];
        for (label e = 0; e < block.size(); ++e)
        {
            for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < dim; ++a)
            {
                x[i][a] = fields.x[block.element(e)[i]][fe_.axis(a)];
                v[i][a] = fields.v[block.element(e)[i]][fe_.axis(a)];
            }
            const double widest2 = fields.widest2 ? (*fields.widest2)[block.cells[e]] : 0;
            double sum = 0, volume = 0;
            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(x, q);
                eddy.reinit(k, w.grad(v), w.detJ, widest2);
                sum += eddy.nut*w.dV;
                volume += w.dV;
            }
            nut[block.cells[e]] = sum/volume;
        }
    });
}


Foam::flowEnergy Foam::flowAssembly::energy(const flowParameters& k, const flowFields& fields) const
{
    flowEnergy E;
    switch (k.family)
    {
        case flowFamily::EQUAL_ORDER: addEnergy<flowFamily::EQUAL_ORDER>(k, fields, E); break;
        case flowFamily::TAYLOR_HOOD: addEnergy<flowFamily::TAYLOR_HOOD>(k, fields, E); break;
        case flowFamily::Q1Q0: addEnergy<flowFamily::Q1Q0>(k, fields, E); break;
    }
    for
    (
        scalar* s :
        {
            &E.kinetic, &E.compression, &E.viscous, &E.eddy, &E.stabilisation, &E.weight, &E.transport
        }
    ) reduce(*s, sumOp<scalar>());
    return E;
}


void Foam::flowAssembly::subscales
(
    const flowParameters& k,
    const flowFields& fields,
    List<vectorField>& s
) const
{
    switch (k.family)
    {
        case flowFamily::EQUAL_ORDER: findSubscales<flowFamily::EQUAL_ORDER>(k, fields, s); break;
        case flowFamily::TAYLOR_HOOD: findSubscales<flowFamily::TAYLOR_HOOD>(k, fields, s); break;
        case flowFamily::Q1Q0: findSubscales<flowFamily::Q1Q0>(k, fields, s); break;
    }
}


// ************************************************************************* //
