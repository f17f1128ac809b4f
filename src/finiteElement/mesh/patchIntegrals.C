/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchIntegrals.H"
#include "feValues.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchIntegrals::patchIntegrals
(
    const feMesh& fe,
    const labelUList& patches,
    const vectorField& x,
    const vectorField& v,
    const scalarField& p
)
:
    area(0),
    flux(0),
    magFlux(0),
    integral(0)
{
    const auto add = [&](const auto element, const elementBlock& block)
    {
        typedef typename std::decay<decltype(element)>::type F;
        faceValues<double, F> face;
        constexpr int dim = F::dim + 1;
        Vec<double, dim> xe[F::nNodes], ve[F::nNodes];
        double pe[F::nNodes];
        for (label e = 0; e < block.size(); ++e)
        {
            for (int i = 0; i < F::nNodes; ++i)
            {
                const label n = block.element(e)[i];
                pe[i] = p[n];
                for (int a = 0; a < dim; ++a)
                {
                    xe[i][a] = x[n][fe.axis(a)];
                    ve[i][a] = v[n][fe.axis(a)];
                }
            }
            for (int q = 0; q < face.nQ; ++q)
            {
                face.reinit(xe, q);
                const scalar dA = ::sqrt(face.ndA & face.ndA), vn = face.value(ve) & face.ndA;
                area += dA;
                flux += vn;
                magFlux += mag(vn);
                integral += face.value(pe)*dA;
            }
        }
    };
    for (const label patchi : patches) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto F) { if (F.dim == fe.dim() - 1) add(F, block); });
    }
    for (scalar* s : {&area, &flux, &magFlux, &integral}) reduce(*s, sumOp<scalar>());
}


// ************************************************************************* //
