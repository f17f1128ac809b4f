/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enhancedKernel.H"
#include <memory>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
template<class Kernel, class E>
Foam::scalar Foam::solidElementLoopOf<Law>::assembleWith
(
    const elementBlock& block,
    const solidStage& stage,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    constexpr int dim = E::dim, nN = E::nNodes;
    solidConstants<dim> k;
    k.rho = rho_;
    k.dDdu = stage.dDdu;
    k.dadu = stage.dadu;
    for (int a = 0; a < dim; ++a) k.g[a] = stage.g[stage.axis[a]];
    scalar detJ = GREAT;

    #pragma omp parallel reduction(min:detJ)
    {
        const auto kernel = std::make_unique<Kernel>(law_);
        const auto nodes = std::make_unique<solidNodes<pack, E>>();
        const auto R = std::make_unique<solidResidual<pack, E>>();
        const auto K = matrix ? std::make_unique<solidTangent<pack, E>>() : nullptr;

        block.forBatches([&](const label batch)
        {
            gather<E, dim>(block, batch, stage.X, stage.axis, nodes->X);
            gather<E, dim>(block, batch, stage.D, stage.axis, nodes->D);
            gather<E, dim>(block, batch, stage.a, stage.axis, nodes->a);

            kernel->residual(k, *nodes, *R);
            detJ = min(detJ, minLane(R->minDetJ));
            for (int l = 0; l < block.nLanes(batch); ++l)
            {
                const label* n = block.element(block.lane(batch, l));
                for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
                {
                    force[n[i]][stage.axis[a]] += R->u[i][a][l];
                }
            }
            if (!matrix) return;

            kernel->tangent(k, *nodes, *K);
            matrix->K.add(matrix->scatter, block, batch, &K->uu[0][0](0, 0), 0, 0, 1);
        });
    }
    return detJ;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Law>
Foam::scalar Foam::solidElementLoopOf<Law>::assemble
(
    const elementBlock& block,
    const solidStage& stage,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    scalar detJ = GREAT;
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        constexpr bool canEnhance = std::is_same<E, Quad1>::value || std::is_same<E, Hex1>::value;
        if constexpr (canEnhance)
        {
            if (stage.enhanced)
            {
                detJ = assembleWith<enhancedKernel<pack, E, Law>, E>(block, stage, force, matrix);
                return;
            }
        }
        detJ = assembleWith<solidKernel<pack, E, Law>, E>(block, stage, force, matrix);
    });
    return detJ;
}


// ************************************************************************* //
