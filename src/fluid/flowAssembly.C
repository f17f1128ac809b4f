/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowAssembly.H"
#include "flowKernel.H"
#include <memory>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<int dim>
flowConstants<dim> constants(const flowParameters& p, const feMesh& fe)
{
    flowConstants<dim> k;
    k.rho = p.rho;
    k.mu = p.mu;
    k.rB = p.rBulk;
    for (int a = 0; a < dim; ++a) k.g[a] = p.g[fe.axis(a)];
    k.dadv = p.dadv;
    k.dqdp = p.dqdp;
    k.dvmdm = p.dvmdm;
    k.supg = p.supg;
    k.pspg = p.pspg;
    k.lsic = p.lsic;
    k.rDt2 = p.deltaT < GREAT ? 4/sqr(p.deltaT) : 0;
    k.CI = p.CI;
    return k;
}


//- The columns of held nodes are no unknowns
template<class T, class V, class P>
void holdNodes
(
    const boolList& held,
    const elementBlock& block,
    const label batch,
    flowTangent<T, V, P>& K
)
{
    for (int l = 0; l < block.nLanes(batch); ++l)
    {
        const label* nodes = block.element(block.lane(batch, l));
        for (int j = 0; j < V::nNodes; ++j)
        {
            if (!held[nodes[j]]) continue;
            for (int b = 0; b < V::dim; ++b)
            {
                for (int i = 0; i < V::nNodes; ++i) for (int a = 0; a < V::dim; ++a)
                {
                    K.uu[i][j](a, b)[l] = 0;
                }
                for (int i = 0; i < P::nNodes; ++i) K.pu[i][j][b][l] = 0;
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class V, class P, bool stabilised>
void Foam::flowAssembly::assembleBlock
(
    const label blocki,
    const flowParameters& parameters,
    const flowFields& fields,
    vectorField& Ru,
    scalarField& Rp,
    scalar& minDetJ,
    flowMatrices* matrices
) const
{
    constexpr int dim = V::dim, nV = V::nNodes, nP = P::nNodes;
    constexpr label velocity = 0, pressure = 1, position = 0;
    const elementBlock& block = fe_.blocks()[blocki];
    const flowConstants<dim> k = constants<dim>(parameters, fe_);
    const FixedList<label, 3> axis({fe_.axis(0), fe_.axis(1), fe_.axis(2)});
    scalar detJ = GREAT;

    #pragma omp parallel reduction(min:detJ)
    {
        const auto kernel = std::make_unique<flowKernel<pack, V, P, stabilised>>();
        const auto nodes = std::make_unique<flowNodes<pack, V, P>>();
        const auto R = std::make_unique<flowResidual<pack, V, P>>();
        const auto K = matrices ? std::make_unique<flowTangent<pack, V, P>>() : nullptr;

        block.forBatches([&](const label batch)
        {
            gather<V, dim>(block, batch, fields.x, axis, nodes->x);
            gather<V, dim>(block, batch, fields.v, axis, nodes->v);
            gather<V, dim>(block, batch, fields.a, axis, nodes->a);
            gather<V, dim>(block, batch, fields.vm, axis, nodes->vm);
            gather(block, batch, fields.p, nP, nodes->p);
            gather(block, batch, fields.q, nP, nodes->q);

            kernel->residual(k, *nodes, *R);
            detJ = min(detJ, minLane(R->minDetJ));
            for (int l = 0; l < block.nLanes(batch); ++l)
            {
                const label* n = block.element(block.lane(batch, l));
                for (int i = 0; i < nV; ++i) for (int a = 0; a < dim; ++a)
                {
                    Ru[n[i]][axis[a]] += R->u[i][a][l];
                }
                for (int i = 0; i < nP; ++i) Rp[n[i]] += R->p[i][l];
            }
            if (!matrices) return;

            const scalar s = matrices->columns;
            if (matrices->K)
            {
                kernel->tangent(k, *nodes, *K);
                if (!matrices->heldNodes.empty()) holdNodes(matrices->heldNodes, block, batch, *K);
                const elementScatter& to = (*matrices->scatter)[blocki];
                matrices->K->add(to, block, batch, &K->uu[0][0](0, 0), velocity, velocity, s);
                matrices->K->add(to, block, batch, &K->up[0][0][0], velocity, pressure, s);
                matrices->K->add(to, block, batch, &K->pu[0][0][0], pressure, velocity, s);
                matrices->K->add(to, block, batch, &K->pp[0][0], pressure, pressure, s);
            }
            if (matrices->S)
            {
                kernel->shapeTangent(k, *nodes, *K);
                const elementScatter& to = (*matrices->shapeScatter)[blocki];
                matrices->S->add(to, block, batch, &K->um[0][0](0, 0), velocity, position, s);
                matrices->S->add(to, block, batch, &K->pm[0][0][0], pressure, position, s);
            }
        });
    }
    minDetJ = min(minDetJ, detJ);
}


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
    scalar minDetJ = GREAT;
    forAll(fe_.blocks(), b)
    {
        withElement(fe_.blocks()[b], [&](auto tag)
        {
            typedef decltype(tag) V;
            typedef typename V::Linear L;
            if constexpr (V::order == 1)
            {
                assembleBlock<V, V, true>(b, k, fields, Ru, Rp, minDetJ, matrices);
            }
            else if (k.stabilised)
            {
                assembleBlock<V, L, true>(b, k, fields, Ru, Rp, minDetJ, matrices);
            }
            else
            {
                assembleBlock<V, L, false>(b, k, fields, Ru, Rp, minDetJ, matrices);
            }
        });
    }
    return minDetJ;
}


// ************************************************************************* //
