/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shellLoop.H"
#include "shellKernel.H"
#include <memory>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The node of a hexahedron at reference coordinates
static int nodeAt(const double x, const double y, const double z)
{
    int n = 0;
    while (Hex1::xi[n][0] != x || Hex1::xi[n][1] != y || Hex1::xi[n][2] != z) ++n;
    return n;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::shellLoop::suits(const solidMaterial& material)
{
    typedef Ten<scalar, 3> ten;
    ten R = ten::zero();
    for (int a = 0; a < 3; ++a) R(a, (a + 1)%3) = 1;
    const ten P = material.P(R), scale = material.dP(ten::I(), ten::I());
    return (P && P) < 1e-12*(scale && scale);
}


void Foam::shellLoop::thicknessLast(const vectorField& points, elementBlock& block)
{
    for (label e = 0; e < block.size(); ++e)
    {
        label* nodes = &block.nodes[e*block.nNodes];
        scalar length[3] = {};
        for (int a = 0; a < 3; ++a) for (int i = 0; i < 8; ++i)
        {
            double x[3] = {Hex1::xi[i][0], Hex1::xi[i][1], Hex1::xi[i][2]};
            x[a] *= -1;
            length[a] += mag(points[nodes[i]] - points[nodes[nodeAt(x[0], x[1], x[2])]]);
        }
        const int thin = std::min_element(length, length + 3) - length;
        label turned[8];
        for (int i = 0; i < 8; ++i)
        {
            double x[3];
            for (int a = 0; a < 3; ++a) x[(thin + 1 + a)%3] = Hex1::xi[i][a];
            turned[i] = nodes[nodeAt(x[0], x[1], x[2])];
        }
        std::copy(turned, turned + 8, nodes);
    }
}


Foam::scalar Foam::shellLoop::assemble
(
    const elementBlock& block,
    const solidStage& stage,
    vectorField& force,
    const solidMatrix* matrix
) const
{
    typedef shellKernel::E E;
    constexpr int nN = E::nNodes;
    solidConstants<3> k;
    k.rho = material_.rho();
    k.dDdu = stage.dDdu;
    k.dadu = stage.dadu;
    for (int a = 0; a < 3; ++a) k.g[a] = stage.g[stage.axis[a]];
    scalar detJ = GREAT;

    #pragma omp parallel reduction(min:detJ)
    {
        const auto kernel = std::make_unique<shellKernel>(material_);
        const auto nodes = std::make_unique<solidNodes<scalar, E>>();
        const auto R = std::make_unique<solidResidual<scalar, E>>();
        const auto one = std::make_unique<solidTangent<scalar, E>>();
        const auto all = std::make_unique<solidTangent<pack, E>>();

        block.forBatches([&](const label batch)
        {
            for (int l = 0; l < packSize; ++l)
            {
                const label* n = block.element(block.lane(batch, l));
                for (int i = 0; i < nN; ++i) for (int a = 0; a < 3; ++a)
                {
                    nodes->X[i][a] = stage.X[n[i]][stage.axis[a]];
                    nodes->D[i][a] = stage.D[n[i]][stage.axis[a]];
                    nodes->a[i][a] = stage.a[n[i]][stage.axis[a]];
                }
                kernel->residual(k, *nodes, *R);
                detJ = min(detJ, R->minDetJ);
                if (l < block.nLanes(batch)) for (int i = 0; i < nN; ++i) for (int a = 0; a < 3; ++a)
                {
                    force[n[i]][stage.axis[a]] += R->u[i][a];
                }
                if (!matrix) continue;
                kernel->tangent(k, *one);
                for (int i = 0; i < nN; ++i) for (int j = 0; j < nN; ++j)
                {
                    for (int a = 0; a < 3; ++a) for (int b = 0; b < 3; ++b)
                    {
                        all->uu[i][j](a, b)[l] = one->uu[i][j](a, b);
                    }
                }
            }
            if (matrix) matrix->K.add(matrix->scatter, block, batch, &all->uu[0][0](0, 0), 0, 0, 1);
        });
    }
    return detJ;
}


// ************************************************************************* //
