/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticMotion.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(elasticMotion, 0);
    addToRunTimeSelectionTable(meshMotion, elasticMotion, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool readNonlinear(const dictionary& dict)
{
    static const Enum<label> models({{0, "linear"}, {1, "neoHookean"}});
    return models.getOrDefault("model", dict, 1) == 1;
}


static scalar readLambda(const dictionary& dict)
{
    const scalar nu = dict.getOrDefault<scalar>("poissonRatio", 0);
    if (!(nu >= 0 && nu < 0.5))
    {
        FatalIOErrorInFunction(dict)
            << "poissonRatio is " << nu << ", expected a number from 0 to less than 0.5"
            << exit(FatalIOError);
    }
    return 2*nu/(1 - 2*nu);
}


//- As feValues, with the vertices as quadrature points
template<class T, class E>
struct vertexValues
{
    static constexpr int dim = E::dim, n = E::nNodes, nQ = E::nVertices;
    Vec<T, dim> dN[n];
    T dV;

    void reinit(const Vec<T, dim>* x, const int q)
    {
        double N[n], dNdXi[n][dim], volume = 0;
        E::shape(E::xi[q], N, dNdXi);
        for (const double w : referenceTable<E>::instance().w) volume += w;
        Ten<T, dim> J = Ten<T, dim>::zero();
        for (int i = 0; i < n; ++i) for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
        {
            J(a, b) += x[i][a]*dNdXi[i][b];
        }
        const T detJ = det(J);
        const Ten<T, dim> inverse = inv(J, detJ);
        dV = detJ*(volume/nQ);
        for (int i = 0; i < n; ++i)
        {
            dN[i] = Vec<T, dim>::zero();
            for (int a = 0; a < dim; ++a) for (int b = 0; b < dim; ++b)
            {
                dN[i][a] += inverse(b, a)*dNdXi[i][b];
            }
        }
    }

    Ten<T, dim> grad(const Vec<T, dim>* u) const
    {
        Ten<T, dim> s = u[0]*dN[0];
        for (int i = 1; i < n; ++i) s += u[i]*dN[i];
        return s;
    }
};


//- Elements of order 1 are inverted at a vertex first, where the energy of the
//  neo-Hookean solid must see it
template<class E, class T>
using motionValues = typename std::conditional
<
    std::is_same<E, Quad1>::value || std::is_same<E, Hex1>::value || std::is_same<E, Prism1>::value,
    vertexValues<T, E>, feValues<T, E>
>::type;


//- Deformation at a quadrature point: F^-T grad N_i, ln J
template<class T, class E>
struct deformation
{
    static constexpr int d = E::dim;
    Ten<T, d> F;
    Vec<T, d> g[E::nNodes];
    T logJ;

    template<class W>
    void set(const W& w, const Vec<T, d>* u)
    {
        F = Ten<T, d>::I() + w.grad(u);
        const T J = det(F);
        const Ten<T, d> inverse = inv(F, J);
        for (int i = 0; i < E::nNodes; ++i) g[i] = w.dN[i] & inverse;

        // A number for inverted elements, too
        logJ = stdx::log(stdx::max(J, T(1e-12)));
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class E>
void Foam::elasticMotion::assembleBlock
(
    feMatrix& matrix,
    const label blocki,
    const vectorField& positions,
    const vectorField& displacement
)
{
    constexpr int d = E::dim;
    if (d != fe_.dim()) return;
    const elementBlock& block = fe_.blocks()[blocki];
    const FixedList<label, 3> axis({fe_.axis(0), fe_.axis(1), fe_.axis(2)});

    #pragma omp parallel
    {
        motionValues<E, pack> w;
        deformation<pack, E> now;
        Vec<pack, d> x[E::nNodes], u[E::nNodes];
        pack K[E::nNodes][E::nNodes][d][d];

        block.forBatches([&](const label batch)
        {
            gather<E, d>(block, batch, positions, axis, x);
            gather<E, d>(block, batch, displacement, axis, u);
            if (!nonlinear_) for (auto& ui : u) ui = Vec<pack, d>::zero();
            pack kappa;
            for (int l = 0; l < packSize; ++l) kappa[l] = kappa_[blocki][block.lane(batch, l)];
            std::fill_n(&K[0][0][0][0], E::nNodes*E::nNodes*d*d, pack(0.0));

            for (int q = 0; q < w.nQ; ++q)
            {
                w.reinit(x, q);
                now.set(w, u);
                const pack dV = kappa*w.dV, m = (1.0 - lambda_*now.logJ)*dV, l = lambda_*dV;
                for (int i = 0; i < E::nNodes; ++i) for (int j = 0; j < E::nNodes; ++j)
                {
                    const pack k = (w.dN[i] & w.dN[j])*dV;
                    for (int a = 0; a < d; ++a)
                    {
                        K[i][j][a][a] += k;
                        for (int b = 0; b < d; ++b)
                        {
                            K[i][j][a][b] += m*now.g[i][b]*now.g[j][a] + l*now.g[i][a]*now.g[j][b];
                        }
                    }
                }
            }
            matrix.add(scatter_[blocki], block, batch, &K[0][0][0][0], 0, 0, 1);
        });
    }
}


template<class E>
void Foam::elasticMotion::addResidualBlock
(
    const label blocki,
    const vectorField& displacement,
    scalarField& R
) const
{
    constexpr int d = E::dim;
    if (d != fe_.dim()) return;
    const elementBlock& block = fe_.blocks()[blocki];
    const FixedList<label, 3> axis({fe_.axis(0), fe_.axis(1), fe_.axis(2)});
    motionValues<E, pack> w;
    deformation<pack, E> now;
    Vec<pack, d> x[E::nNodes], u[E::nNodes], r[E::nNodes];

    for (label batch = 0; batch < block.nBatches(); ++batch)
    {
        gather<E, d>(block, batch, fe_.points(), axis, x);
        gather<E, d>(block, batch, displacement, axis, u);
        for (auto& ri : r) ri = Vec<pack, d>::zero();
        for (int q = 0; q < w.nQ; ++q)
        {
            w.reinit(x, q);
            now.set(w, u);
            const pack p = lambda_*now.logJ - 1.0;
            for (int i = 0; i < E::nNodes; ++i) r[i] += ((now.F & w.dN[i]) + now.g[i]*p)*w.dV;
        }
        for (int l = 0; l < block.nLanes(batch); ++l)
        {
            const label e = block.lane(batch, l);
            for (int i = 0; i < E::nNodes; ++i)
            {
                const label start = unknowns_->start(0, block.element(e)[i]);
                for (int a = 0; a < d; ++a) R[start + a] += kappa_[blocki][e]*r[i][a][l];
            }
        }
    }
}


void Foam::elasticMotion::assemble(feMatrix& matrix, const vectorField& x, const vectorField& u)
{
    forAll(fe_.blocks(), b)
    {
        withElement(fe_.blocks()[b], [&](auto E) { assembleBlock<decltype(E)>(matrix, b, x, u); });
    }
}


void Foam::elasticMotion::addResidual(const vectorField& u, scalarField& R) const
{
    forAll(fe_.blocks(), b)
    {
        withElement(fe_.blocks()[b], [&](auto E) { addResidualBlock<decltype(E)>(b, u, R); });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elasticMotion::elasticMotion
(
    const feMesh& fe,
    pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver
)
:
    nodalMotion(fe, boundary, heldPatches, dict, solver, {"model", "poissonRatio"}),
    nonlinear_(readNonlinear(dict)),
    lambda_(readLambda(dict))
{
    if (nonlinear_ && incremental_)
    {
        FatalIOErrorInFunction(dict)
            << "configuration incremental is for model linear: neoHookean is of the reference mesh"
            << exit(FatalIOError);
    }
    initialise(false);
}


// ************************************************************************* //
