/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumeLoad.H"
#include "feValues.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::addVolumeLoad
(
    const feMesh& fe,
    const vectorField& x,
    const volumeLoad& f,
    const scalar t,
    vectorField& force
)
{
    for (const elementBlock& block : fe.blocks())
    {
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            if (E::dim != fe.dim()) return;
            feValues<double, E> w;
            Vec<double, E::dim> xe[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                const label* n = block.element(e);
                for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                {
                    xe[i][a] = x[n[i]][fe.axis(a)];
                }
                for (int q = 0; q < w.nQ; ++q)
                {
                    w.reinit(xe, q);
                    point X = Zero;
                    for (int i = 0; i < E::nNodes; ++i) X += w.N[i]*x[n[i]];
                    const vector fV = f(X, t)*w.dV;
                    for (int i = 0; i < E::nNodes; ++i) force[n[i]] -= w.N[i]*fV;
                }
            }
        });
    }
}


// ************************************************************************* //
