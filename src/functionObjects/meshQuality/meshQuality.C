/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(meshQuality, 0);
    addToRunTimeSelectionTable(functionObject, meshQuality, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Of the regular shape: l^d/V, determinant of the unit vectors along the
//  edges at a corner
struct regularShape
{
    scalar c;
    scalar corner;
};

static regularShape regular(const elementShape shape)
{
    const scalar sqrt2 = Foam::sqrt(2.0), sqrt3 = Foam::sqrt(3.0);
    switch (shape)
    {
        case elementShape::TRI:     return {4/sqrt3, 0.5*sqrt3};
        case elementShape::TET:     return {6*sqrt2, 1/sqrt2};
        case elementShape::PRISM:   return {4/sqrt3, 0.5*sqrt3};
        case elementShape::PYRAMID: return {3*sqrt2, 1/sqrt2};
        default:                    return {1, 1};
    }
}


//- Determinant of the unit vectors along the d edges that meet at corner i, in
//  the order that makes it positive in the reference element
template<class L>
static scalar cornerDeterminant(const Vec<double, L::dim>* x, const int i)
{
    constexpr int d = L::dim;
    Ten<double, d> J = Ten<double, d>::zero(), ref = J;
    int n = 0;
    for (int e = 0; e < L::nEdges; ++e)
    {
        const int a = L::edges[e][0], b = L::edges[e][1];
        if (a != i && b != i) continue;
        if (n == d) return GREAT;       // apex of a pyramid: left out
        const int j = a == i ? b : a;
        scalar length = 0;
        for (int c = 0; c < d; ++c) length += sqr(x[j][c] - x[i][c]);
        length = max(Foam::sqrt(length), VSMALL);
        for (int c = 0; c < d; ++c)
        {
            J(c, n) = (x[j][c] - x[i][c])/length;
            ref(c, n) = L::xi[j][c] - L::xi[i][c];
        }
        ++n;
    }
    return det(ref) < 0 ? -det(J) : det(J);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class E>
void Foam::functionObjects::meshQuality::add
(
    const elementBlock& block,
    const vectorField& x,
    const vectorField& X
)
{
    typedef typename E::Linear L;
    constexpr int d = E::dim;
    const feMesh& fe = region().fe();
    const regularShape reg = regular(block.shape);

    feValues<double, E> now, reference;
    feValues<double, L> corners;
    Vec<double, d> xe[E::nNodes], Xe[E::nNodes];

    for (label e = 0; e < block.size(); ++e)
    {
        for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < d; ++a)
        {
            xe[i][a] = x[block.element(e)[i]][fe.axis(a)];
            Xe[i][a] = X[block.element(e)[i]][fe.axis(a)];
        }

        for (int q = 0; q < now.nQ; ++q)
        {
            now.reinit(xe, q);
            reference.reinit(Xe, q);
            minDetJ_ = min(minDetJ_, now.detJ/reference.detJ);
        }

        for (int i = 0; i < L::nNodes; ++i)
        {
            minScaledJacobian_ =
                min(minScaledJacobian_, cornerDeterminant<L>(xe, i)/reg.corner);
        }

        scalar l = 0, V = 0;
        for (int i = 0; i < L::nEdges; ++i)
        {
            scalar s = 0;
            for (int a = 0; a < d; ++a)
            {
                s += sqr(xe[L::edges[i][1]][a] - xe[L::edges[i][0]][a]);
            }
            l += Foam::sqrt(s)/L::nEdges;
        }
        for (int q = 0; q < corners.nQ; ++q)
        {
            corners.reinit(xe, q);
            V += corners.dV;
        }
        const scalar AR = V > 0 ? pow(l, scalar(d))/V/reg.c : GREAT;
        maxAspectRatio_ = max(maxAspectRatio_, AR);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::meshQuality::meshQuality
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, typeName),
    minDetJ_(GREAT),
    minScaledJacobian_(GREAT),
    maxAspectRatio_(0)
{
    read(dict);
    reportUnknownEntries(dict, {});

    writeHeader(file(), "Worst elements of the mesh");
    writeColumns(file(), {"minDetJ", "minScaledJacobian", "maxAspectRatio"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::meshQuality::execute()
{
    const feMesh& fe = region().fe();
    const vectorField x(positions());

    minDetJ_ = minScaledJacobian_ = GREAT;
    maxAspectRatio_ = 0;
    for (const elementBlock& block : fe.blocks())
    {
        withElement(block, [&](auto E) { add<decltype(E)>(block, x, fe.points()); });
    }
    reduce(minDetJ_, minOp<scalar>());
    reduce(minScaledJacobian_, minOp<scalar>());
    reduce(maxAspectRatio_, maxOp<scalar>());

    setResult("minDetJ", minDetJ_);
    setResult("minScaledJacobian", minScaledJacobian_);
    setResult("maxAspectRatio", maxAspectRatio_);

    return true;
}


bool Foam::functionObjects::meshQuality::write()
{
    Log << type() << " " << name() << " write:" << nl
        << "    min det J ratio     : " << minDetJ_ << nl
        << "    min scaled Jacobian : " << minScaledJacobian_ << nl
        << "    max aspect ratio    : " << maxAspectRatio_ << nl << endl;

    writeRow(file(), {minDetJ_, minScaledJacobian_, maxAspectRatio_});
    return true;
}


// ************************************************************************* //
