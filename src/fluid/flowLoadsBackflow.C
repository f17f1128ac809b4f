/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowLoads.H"
#include "feValues.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::flowLoads::inflow(const label patchi, const flowFields& stage) const
{
    scalar largest = 0;
    for (const elementBlock& block : fe_.patchBlocks(patchi)) withFaceElement(block, [&](auto tag)
    {
        typedef decltype(tag) F;
        constexpr int dim = F::dim + 1;
        if (dim != fe_.dim()) return;
        faceValues<double, F> face;
        Vec<double, dim> x[F::nNodes], c[F::nNodes];
        for (label e = 0; e < block.size(); ++e)
        {
            for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < dim; ++a)
            {
                const label n = block.element(e)[i], axis = fe_.axis(a);
                x[i][a] = stage.x[n][axis];
                c[i][a] = stage.v[n][axis] - stage.vm[n][axis];
            }
            for (int q = 0; q < face.nQ; ++q)
            {
                face.reinit(x, q);
                largest = max(largest, -(face.value(c) & face.ndA)/::sqrt(face.ndA & face.ndA));
            }
        }
    });
    return returnReduce(largest, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::flowLoads::backflowReport(const flowFields& stage) const
{
    scalar fastest = 0;
    for (const vector& v : stage.v) fastest = max(fastest, mag(v));
    reduce(fastest, maxOp<scalar>());

    OStringStream os;
    forAll(pointU_.boundaryField(), patchi)
    {
        const pointPatchVectorField& pf = pointU_.boundaryField()[patchi];
        if (!isOpen(pf) || returnReduce(pf.patch().meshPoints().empty(), andOp<bool>())) continue;
        const scalar in = inflow(patchi, stage);
        if (in < 0.1*fastest || in < VSMALL) continue;
        os  << "Fluid comes in through patch " << pf.patch().name() << " of region " << fe_.mesh().name()
            << ", with up to " << in << " m/s of " << fastest << " m/s in all of it. If it should not, this may be"
            << " what breaks the run: backflowStabilisation 1 there, or an opening further away. If it"
            << " should, give its total pressure (openBoundary, pressureIs total) or its velocity" << nl;
    }
    return os.str();
}


// ************************************************************************* //
