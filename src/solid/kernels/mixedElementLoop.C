/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mixedKernel.H"
#include <memory>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Law>
template<class E, class Q>
Foam::scalar Foam::mixedElementLoopOf<Law>::assembleWith
(
    const elementBlock& block,
    const mixedStage& stage,
    vectorField& force,
    scalarField& volume,
    const solidMatrix* matrix
) const
{
    constexpr int dim = E::dim, nN = E::nNodes, nP = Q::nNodes;
    constexpr label displacement = 0, pressure = 1;
    solidConstants<dim> k;
    k.rho = rho_;
    k.dDdu = stage.dDdu;
    k.dadu = stage.dadu;
    for (int a = 0; a < dim; ++a) k.g[a] = stage.g[stage.axis[a]];
    const mixedConstants constants{rKappa_, 1/law_.shearModulus()};
    const auto place = [&](const label e, const int i)
    {
        return nP == 1 ? block.cells[e] : block.element(e)[i];
    };
    scalar detJ = GREAT;

    #pragma omp parallel reduction(min:detJ)
    {
        const auto kernel = std::make_unique<mixedKernel<pack, E, Q, Law>>(law_, constants);
        const auto nodes = std::make_unique<mixedNodes<pack, E, Q>>();
        const auto R = std::make_unique<mixedResidual<pack, E, Q>>();
        const auto K = matrix ? std::make_unique<mixedTangent<pack, E, Q>>() : nullptr;

        block.forBatches([&](const label batch)
        {
            gather<E, dim>(block, batch, stage.X, stage.axis, nodes->X);
            gather<E, dim>(block, batch, stage.D, stage.axis, nodes->D);
            gather<E, dim>(block, batch, stage.a, stage.axis, nodes->a);
            for (int i = 0; i < nP; ++i) for (int l = 0; l < packSize; ++l)
            {
                nodes->p[i][l] = stage.p[place(block.lane(batch, l), i)];
            }

            kernel->residual(k, *nodes, *R);
            detJ = min(detJ, minLane(R->minDetJ));
            for (int l = 0; l < block.nLanes(batch); ++l)
            {
                const label e = block.lane(batch, l);
                const label* n = block.element(e);
                for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
                {
                    force[n[i]][stage.axis[a]] += R->u[i][a][l];
                }
                for (int i = 0; i < nP; ++i) volume[place(e, i)] += R->p[i][l];
            }
            if (!matrix) return;

            kernel->tangent(k, *nodes, *K);
            const elementScatter& to = matrix->scatter;
            matrix->K.add(to, block, batch, &K->uu[0][0](0, 0), displacement, displacement, 1);
            matrix->K.add(to, block, batch, &K->up[0][0][0], displacement, pressure, 1);
            matrix->K.add(to, block, batch, &K->pu[0][0][0], pressure, displacement, 1);
            matrix->K.add(to, block, batch, &K->pp[0][0], pressure, pressure, 1);
        });
    }
    return detJ;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Law>
Foam::scalar Foam::mixedElementLoopOf<Law>::assemble
(
    const elementBlock& block,
    const mixedStage& stage,
    vectorField& force,
    scalarField& volume,
    const solidMatrix* matrix
) const
{
    scalar detJ = GREAT;
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        typedef typename E::Linear L;
        if (stage.pressureOn != fieldLayout::support::CELLS)
        {
            detJ = assembleWith<E, L>(block, stage, force, volume, matrix);
            return;
        }
        constexpr bool isQ1 = std::is_same<E, Quad1>::value || std::is_same<E, Hex1>::value;
        if constexpr (isQ1) detJ = assembleWith<E, Constant<E>>(block, stage, force, volume, matrix);
    });
    return detJ;
}


// ************************************************************************* //
