/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feValues.H"
#include "symmetricSolve.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class E>
Foam::Ten<Foam::scalar, 3> Foam::solidPoints::viscousStress
(
    const label blocki,
    const label cell,
    const label q
) const
{
    const solidViscosity& viscosity = assembly_.viscosity(blocki);
    constexpr label nQ = referenceTable<E>::nQ;
    const label first = max(q, 0), n = q < 0 ? nQ : 1;
    Ten<scalar, E::dim> sum = Ten<scalar, E::dim>::zero();
    for (label i = 0; i < viscosity.nBranches(); ++i) for (label k = first; k < first + n; ++k)
    {
        sum += (viscosity.g(i)/n)*history_.stress<E::dim>(history_.now, k, 1 + i, cell);
    }
    Ten<scalar, 3> S = Ten<scalar, 3>::zero();
    for (int a = 0; a < E::dim; ++a) for (int b = 0; b < E::dim; ++b)
    {
        S(fe_.axis(a), fe_.axis(b)) = sum(a, b);
    }
    return S;
}


template<class E>
Foam::solidPoint Foam::solidPoints::point
(
    const label blocki,
    const label e,
    const double (*dN)[E::dim],
    const double* vertices,
    const label q
) const
{
    // d X/d xi and d D/d xi; with the unit tensor out of plane
    typedef Ten<scalar, 3> ten;
    const elementBlock& block = assembly_.blocks()[blocki];
    const label *nodes = block.element(e), cell = block.cells[e];
    ten dX = ten::zero(), dD = ten::zero();
    for (int c = E::dim; c < 3; ++c) dX(fe_.axis(c), c) = 1;
    for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a) for (int c = 0; c < E::dim; ++c)
    {
        const label k = fe_.axis(a);
        dX(k, c) += fe_.points()[nodes[i]][k]*dN[i][c];
        dD(k, c) += D_[nodes[i]][k]*dN[i][c];
    }

    solidPoint s;
    s.F = (dD & inv(dX)).addDiag(1);
    const solidMaterial& material = assembly_.material(blocki);
    if (assembly_.mixed(blocki))
    {
        // -p J F^-T, p^2/(2 kappa)
        const auto& law = static_cast<const mixedMaterial&>(material);
        scalar p = nodal_ ? 0 : p_[cell];
        if (nodal_) for (int i = 0; i < E::nVertices; ++i) p += vertices[i]*(*nodal_)[nodes[i]];
        const scalar J = det(s.F);
        s.P = law.Piso(s.F) - (p*J)*inv(s.F, J).t();
        s.W = law.Wiso(s.F) + 0.5*law.rKappa()*sqr(p);
    }
    else
    {
        s.P = material.P(s.F);
        s.W = material.W(s.F);
    }
    if (history_.size()) s.P += s.F & viscousStress<E>(blocki, cell, q);
    if (assembly_.prestress())
    {
        ten S0;
        const tensor S((*assembly_.prestress())[cell]);
        for (int a = 0; a < 3; ++a) for (int b = 0; b < 3; ++b) S0(a, b) = S(a, b);
        s.P += s.F & S0;
        s.W += 0.5*(S0 && ((s.F.t() & s.F) - ten::I()));
    }
    return s;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class F>
void Foam::solidPoints::atCentres(const F& f) const
{
    forAll(assembly_.blocks(), b)
    {
        const elementBlock& block = assembly_.blocks()[b];
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            double centre[E::dim] = {}, vertices[E::nVertices], N[E::nNodes], dN[E::nNodes][E::dim];
            for (int i = 0; i < E::nVertices; ++i)
            {
                vertices[i] = 1.0/E::nVertices;
                for (int c = 0; c < E::dim; ++c) centre[c] += E::xi[i][c]/E::nVertices;
            }
            E::shape(centre, N, dN);
            for (label e = 0; e < block.size(); ++e) f(b, e, point<E>(b, e, dN, vertices, -1));
        });
    }
}


template<class F>
void Foam::solidPoints::atQuadrature(const F& f) const
{
    forAll(assembly_.blocks(), b)
    {
        const elementBlock& block = assembly_.blocks()[b];
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            feValues<scalar, E> w;
            const auto& linear = referenceTable<typename E::Linear, E>::instance();
            Vec<scalar, E::dim> X[E::nNodes];
            for (label e = 0; e < block.size(); ++e)
            {
                for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < E::dim; ++a)
                {
                    X[i][a] = fe_.points()[block.element(e)[i]][fe_.axis(a)];
                }
                for (int q = 0; q < w.nQ; ++q)
                {
                    w.reinit(X, q);
                    f(tag, b, e, q, w.dV, point<E>(b, e, w.ref.dN[q], linear.N[q], q));
                }
            }
        });
    }
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::solidPoints::cells(Type (solidPoint::*of)() const) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(fe_.mesh().nCells(), Zero));
    Field<Type>& values = tvalues.ref();
    atCentres([&](const label b, const label e, const solidPoint& s)
    {
        values[assembly_.blocks()[b].cells[e]] = (s.*of)();
    });
    return tvalues;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::solidPoints::vertices(Type (solidPoint::*of)() const) const
{
    tmp<Field<Type>> tsum(new Field<Type>(fe_.nNodes(), Zero));
    Field<Type>& sum = tsum.ref();
    scalarField volume(fe_.nNodes(), 0);
    const scalarField& V = fe_.mesh().cellVolumes();
    const auto add = [&](const elementBlock& block, const label e, const int i, const Type& value)
    {
        const label n = block.element(e)[i], cell = block.cells[e];
        sum[n] += V[cell]*value;
        volume[n] += V[cell];
    };

    const Field<Type> centre(fe_.order() == 1 ? cells<Type>(of) : tmp<Field<Type>>(new Field<Type>()));
    if (fe_.order() == 1) for (const elementBlock& block : assembly_.blocks())
    {
        for (label e = 0; e < block.size(); ++e) for (label i = 0; i < block.nVertices(); ++i)
        {
            add(block, e, i, centre[block.cells[e]]);
        }
    }

    // Least squares: (N_i, N_j) a_j = (N_i, value) with the vertices' N
    Type integral[8];
    scalar mass[8][8];
    if (fe_.order() == 2) atQuadrature
    (
        [&](auto tag, const label b, const label e, const int q, const scalar dV, const solidPoint& s)
        {
            typedef decltype(tag) E;
            const auto& linear = referenceTable<typename E::Linear, E>::instance();
            constexpr int n = E::nVertices;
            if (q == 0) for (int i = 0; i < n; ++i)
            {
                integral[i] = Zero;
                for (int j = 0; j < n; ++j) mass[i][j] = 0;
            }
            const Type value = (s.*of)();
            for (int i = 0; i < n; ++i)
            {
                integral[i] += (linear.N[q][i]*dV)*value;
                for (int j = 0; j < n; ++j) mass[i][j] += linear.N[q][i]*linear.N[q][j]*dV;
            }
            if (q + 1 < linear.nQ) return;

            const symmetricSolve<scalar, n> inverse([&](const int i, const int j) { return mass[i][j]; });
            Type fit[n];
            for (direction c = 0; c < pTraits<Type>::nComponents; ++c)
            {
                scalar x[n];
                for (int i = 0; i < n; ++i) x[i] = component(integral[i], c);
                inverse.solve(x);
                for (int i = 0; i < n; ++i) setComponent(fit[i], c) = x[i];
            }
            for (int i = 0; i < n; ++i) add(assembly_.blocks()[b], e, i, fit[i]);
        }
    );

    if (Pstream::parRun())
    {
        fe_.copies().sum(volume);
        for (direction c = 0; c < pTraits<Type>::nComponents; ++c)
        {
            scalarField x(sum.component(c));
            fe_.copies().sum(x);
            sum.replace(c, x);
        }
    }
    sum /= max(volume, VSMALL);
    return tsum;
}


// ************************************************************************* //
