/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousLoop.H"
#include <memory>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class E>
void Foam::viscousLoop::gather
(
    const elementBlock& block,
    const label e,
    viscousKernel<E>& k
) const
{
    for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
    {
        const label n = block.element(e)[i], c = stage.axis[a];
        k.X[i][a] = stage.X[n][c];
        k.D[i][a] = stage.D[n][c];
        k.v[i][a] = v[n][c];
        k.D1[i][a] = D[n][c];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousLoop::assemble
(
    const elementBlock& block,
    const viscousHistory& history,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        constexpr int dim = E::dim, nN = E::nNodes;

        #pragma omp parallel
        {
            viscousKernel<E> kernel(step, history);
            Vec<scalar, dim> R[nN];
            const auto one = std::make_unique<solidTangent<scalar, E>>();
            const auto batchK = std::make_unique<solidTangent<pack, E>>();

            block.forBatches([&](const label batch)
            {
                for (int l = 0; l < packSize; ++l)
                {
                    const label e = block.lane(batch, l);
                    gather(block, e, kernel);
                    if (l < block.nLanes(batch))
                    {
                        kernel.residual(block.cells[e], R);
                        for (int i = 0; i < nN; ++i) for (int a = 0; a < dim; ++a)
                        {
                            force[block.element(e)[i]][stage.axis[a]] += R[i][a];
                        }
                    }
                    if (!matrix) continue;
                    kernel.tangent(block.cells[e], one->uu);
                    for (int i = 0; i < nN; ++i) for (int j = 0; j < nN; ++j)
                    {
                        for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
                        {
                            batchK->uu[i][j](a, b)[l] = one->uu[i][j](a, b);
                        }
                    }
                }
                if (!matrix) return;
                matrix->K.add(matrix->scatter, block, batch, &batchK->uu[0][0](0, 0), 0, 0, 1);
            });
        }
    });
}


void Foam::viscousLoop::finish
(
    const elementBlock& block,
    const bool steady,
    viscousHistory& history
) const
{
    withElement(block, [&](auto tag)
    {
        viscousKernel<decltype(tag)> kernel(step, history);
        for (label e = 0; e < block.size(); ++e)
        {
            gather(block, e, kernel);
            kernel.finish(block.cells[e], steady, history);
        }
    });
}


// ************************************************************************* //
