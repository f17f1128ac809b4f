/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplaceMotion.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(laplaceMotion, 0);
    addToRunTimeSelectionTable(meshMotion, laplaceMotion, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Scalar element matrices, for each component of the one field
template<int n>
static void addComponents
(
    feMatrix& K,
    const elementScatter& scatter,
    const elementBlock& block,
    const label batch,
    const pack (&k)[n][n]
)
{
    const auto add = [&](const auto cmpts)
    {
        constexpr int d = cmpts();
        pack all[n][n][d][d];
        for (int i = 0; i < n; ++i) for (int j = 0; j < n; ++j)
        {
            for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b)
            {
                all[i][j][a][b] = a == b ? k[i][j] : pack(0.0);
            }
        }
        K.add(scatter, block, batch, &all[0][0][0][0], 0, 0, 1);
    };
    switch (scatter.rows[0].nCmpts)
    {
        case 1: K.add(scatter, block, batch, &k[0][0], 0, 0, 1); break;
        case 2: add(std::integral_constant<int, 2>()); break;
        case 3: add(std::integral_constant<int, 3>()); break;
    }
}


template<class E>
static void addBlock
(
    feMatrix& matrix,
    const elementScatter& scatter,
    const elementBlock& block,
    const feMesh& fe,
    const vectorField& points,
    const scalarField& kappa
)
{
    constexpr int dim = E::dim;
    const FixedList<label, 3> axis({fe.axis(0), fe.axis(1), fe.axis(2)});

    #pragma omp parallel
    {
        feValues<pack, E> w;
        Vec<pack, dim> x[E::nNodes];
        pack K[E::nNodes][E::nNodes];

        block.forBatches([&](const label batch)
        {
            gather<E, dim>(block, batch, points, axis, x);
            pack k;
            for (int l = 0; l < packSize; ++l) k[l] = kappa[block.lane(batch, l)];

            for (auto& row : K) for (pack& Kij : row) Kij = 0;
            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(x, q);
                for (int i = 0; i < E::nNodes; ++i) for (int j = 0; j < E::nNodes; ++j)
                {
                    K[i][j] += k*(w.dN[i] & w.dN[j])*w.dV;
                }
            }
            addComponents(matrix, scatter, block, batch, K);
        });
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::addLaplacian
(
    feMatrix& matrix,
    const UPtrList<elementScatter>& scatter,
    const feMesh& fe,
    const vectorField& x,
    const List<scalarField>& kappa
)
{
    forAll(fe.blocks(), b)
    {
        withElement(fe.blocks()[b], [&](auto E)
        {
            addBlock<decltype(E)>(matrix, scatter[b], fe.blocks()[b], fe, x, kappa[b]);
        });
    }
}


// ************************************************************************* //
