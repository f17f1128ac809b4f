/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementQuality.H"
#include "jacobianBound.H"
#include "feValues.H"
#include "cubicEqn.H"
#include "quadraticEqn.H"
#include "unitConversion.H"
#include "Tuple2.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- l^d/V of the regular shape
scalar regularRatio(const elementShape shape)
{
    switch (shape)
    {
        case elementShape::TRI:
        case elementShape::PRISM:   return 4/Foam::sqrt(3.0);
        case elementShape::TET:     return 6*Foam::sqrt(2.0);
        case elementShape::PYRAMID: return 3*Foam::sqrt(2.0);
        default:                    return 1;
    }
}


template<class E>
struct elementVectors
{
    static constexpr int d = E::dim;
    typedef Vec<double, d> vec;

    //- Nodes of an element in the directions of the case
    static void gather(const feMesh& fe, const elementBlock& block, const label e, const vectorField& f, vec* x)
    {
        const label* nodes = block.element(e);
        for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < d; ++a) x[i][a] = f[nodes[i]][fe.axis(a)];
    }
};


template<class V>
scalar length(const V& v) { return Foam::sqrt(v & v); }

//- Angle between two vectors across the direction t, degrees
template<class V>
scalar angleAcross(V a, V b, V t)
{
    t = t*(1/max(length(t), VSMALL));
    a -= (a & t)*t;
    b -= (b & t)*t;
    const scalar c = (a & b)/max(length(a)*length(b), VSMALL);
    return radToDeg(Foam::acos(min(max(c, scalar(-1)), scalar(1))));
}


template<class V>
scalar determinant(const V* column)
{
    constexpr int d = V::dim;
    Ten<double, d> T;
    for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b) T(a, b) = column[b][a];
    return det(T);
}


//- Angles at the vertices, from the edges that meet there
template<class E>
void addAngles(const Vec<double, E::dim>* x, elementQuality& q)
{
    constexpr int d = E::dim;
    const auto take = [&](const scalar angle)
    {
        q.minAngle = min(q.minAngle, angle);
        q.maxAngle = max(q.maxAngle, angle);
    };
    for (int v = 0; v < E::nVertices; ++v)
    {
        Vec<double, d> t[4];
        int n = 0;
        for (int e = 0; e < E::nEdges; ++e)
        {
            const int a = E::edges[e][0], b = E::edges[e][1];
            if (a == v || b == v) t[n++] = x[a == v ? b : a] - x[v];
        }
        if (d == 2) take(angleAcross(t[0], t[1], Vec<double, d>::zero()));

        // A pyramid's apex has its edges in the order of the base's vertices
        else for (int k = 0; k < n; ++k) take(angleAcross(t[(k + 1)%n], t[(k + n - 1)%n], t[k]));
    }
}


template<class E>
void addBlock(const feMesh& fe, const elementBlock& block, const vectorField& x, List<elementQuality>& list)
{
    typedef typename E::Linear L;
    constexpr int d = E::dim;
    if (d != fe.dim()) return;
    const scalar c = regularRatio(block.shape);
    const referenceTable<L>& table = referenceTable<L>::instance();
    typedef Vec<double, d> vec;
    jacobianBound<E> bound;
    vec xe[E::nNodes];

    forAll(list, e)
    {
        elementVectors<E>::gather(fe, block, e, x, xe);
        scalar l = 0, V = 0;
        for (const auto& edge : L::edges) l += length(xe[edge[1]] - xe[edge[0]])/L::nEdges;
        for (int q = 0; q < table.nQ; ++q)
        {
            // Without the inverse, which a flat element has not
            vec J[d];
            for (int b = 0; b < d; ++b)
            {
                J[b] = vec::zero();
                for (int i = 0; i < L::nNodes; ++i) J[b] += xe[i]*table.dN[q][i][b];
            }
            V += determinant(J)*table.w[q];
        }
        elementQuality& quality = list[e];
        quality = {V, V > 0 ? Foam::pow(l, scalar(d))/V/c : GREAT, bound(xe), GREAT, 0};
        addAngles<L>(xe, quality);
    }
}


template<class R>
scalar leastPositive(const R& r, const int n)
{
    scalar least = GREAT;
    for (int i = 0; i < n; ++i) if (r.type(i) == roots::real && r[i] > 0) least = min(least, r[i]);
    return least;
}


//- Least n > 0 with det(J + n dJ) = 0
scalar root(const Vec<double, 2>* J, const Vec<double, 2>* dJ)
{
    const Vec<double, 2> a[] = {dJ[0], J[1]}, b[] = {J[0], dJ[1]};
    const scalar J0 = determinant(J), scale = 1/max(mag(J0), VSMALL);
    const scalar c1 = (determinant(a) + determinant(b))*scale, c2 = determinant(dJ)*scale;
    return leastPositive(quadraticEqn(c2, c1, J0*scale).roots(), 2);
}

scalar root(const Vec<double, 3>* J, const Vec<double, 3>* dJ)
{
    const scalar J0 = determinant(J), scale = 1/max(mag(J0), VSMALL);
    scalar c1 = 0, c2 = 0;
    for (int k = 0; k < 3; ++k)
    {
        Vec<double, 3> one[] = {J[0], J[1], J[2]}, two[] = {dJ[0], dJ[1], dJ[2]};
        one[k] = dJ[k];
        two[k] = J[k];
        c1 += determinant(one)*scale;
        c2 += determinant(two)*scale;
    }
    return leastPositive(cubicEqn(determinant(dJ)*scale, c2, c1, J0*scale).roots(), 3);
}


template<class E>
void forecastBlock
(
    const feMesh& fe,
    const label blocki,
    const vectorField& x,
    const vectorField& dx,
    inversionForecast& first
)
{
    typedef jacobianLattice<E> L;
    constexpr int d = E::dim;
    if (d != fe.dim()) return;
    const elementBlock& block = fe.blocks()[blocki];
    Vec<double, d> xe[E::nNodes], dxe[E::nNodes], J[d], dJ[d];
    for (label e = 0; e < block.size(); ++e)
    {
        elementVectors<E>::gather(fe, block, e, x, xe);
        if (dx.size()) elementVectors<E>::gather(fe, block, e, dx, dxe);
        for (int i = 0; i < E::nNodes; ++i)
        {
            L::columns(xe, E::xi[i], J);
            scalar n = determinant(J) > 0 ? GREAT : 0;
            if (n > 0 && dx.size())
            {
                L::columns(dxe, E::xi[i], dJ);
                n = root(J, dJ);
            }
            if (n < first.steps) first = {n, blocki, e};
        }
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::elementQuality::VOCH(const elementQuality& reference) const
{
    if (volume <= 0 || reference.volume <= 0) return GREAT;
    return Foam::exp(mag(Foam::log(volume/reference.volume)));
}


Foam::scalar Foam::elementQuality::ARCH(const elementQuality& reference) const
{
    if (volume <= 0 || reference.volume <= 0) return GREAT;
    return Foam::exp(mag(Foam::log(aspectRatio/reference.aspectRatio)));
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::List<Foam::qualityMeasure>& Foam::qualityMeasures()
{
    typedef const elementQuality& Q;
    static const List<qualityMeasure> measures
    ({
        {"scaledJacobian", "minScaledJacobian", true, [](Q q, Q) { return q.scaledJacobian; }},
        {"aspectRatio", "maxAspectRatio", false, [](Q q, Q) { return q.aspectRatio; }},
        {"VOCH", "maxVOCH", false, [](Q q, Q q0) { return q.VOCH(q0); }},
        {"ARCH", "maxARCH", false, [](Q q, Q q0) { return q.ARCH(q0); }},
        {"minAngle", "minAngle", true, [](Q q, Q) { return q.minAngle; }},
        {"maxAngle", "maxAngle", false, [](Q q, Q) { return q.maxAngle; }}
    });
    return measures;
}


Foam::elementQualities Foam::qualities(const feMesh& fe, const vectorField& x)
{
    elementQualities all(fe.blocks().size());
    forAll(all, b)
    {
        all[b].setSize(fe.blocks()[b].size());
        withElement(fe.blocks()[b], [&](auto E) { addBlock<decltype(E)>(fe, fe.blocks()[b], x, all[b]); });
    }
    return all;
}


Foam::inversionForecast Foam::forecast
(
    const feMesh& fe,
    const vectorField& x,
    const vectorField& dx
)
{
    inversionForecast first{GREAT, -1, -1};
    forAll(fe.blocks(), b)
    {
        withElement(fe.blocks()[b], [&](auto E) { forecastBlock<decltype(E)>(fe, b, x, dx, first); });
    }

    // The lowest of the ranks that have the least number
    typedef Tuple2<scalar, label> number;
    number least(first.steps, Pstream::myProcNo());
    reduce(least, [](const number& a, const number& b)
    {
        return a.first() < b.first() || (a.first() == b.first() && a.second() < b.second()) ? a : b;
    });
    first.steps = least.first();
    if (least.second() != Pstream::myProcNo()) first.block = first.element = -1;
    return first;
}


// ************************************************************************* //
