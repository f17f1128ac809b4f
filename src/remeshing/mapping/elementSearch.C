/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementSearch.H"
#include "feTensor.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(treeDataElement, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- How far outside the reference element a place is, <= 0 inside
scalar excess(const elementShape shape, const scalar* xi)
{
    switch (shape)
    {
        case elementShape::TRI:
            return max(max(-xi[0], -xi[1]), xi[0] + xi[1] - 1);
        case elementShape::TET:
            return max(max(-xi[0], -xi[1]), max(-xi[2], xi[0] + xi[1] + xi[2] - 1));
        case elementShape::PRISM:
            return max(max(max(-xi[0], -xi[1]), xi[0] + xi[1] - 1), mag(xi[2]) - 1);
        case elementShape::PYRAMID:
            return max(max(mag(xi[0]), mag(xi[1])) + xi[2] - 1, -xi[2]);
        case elementShape::QUAD:
            return max(mag(xi[0]), mag(xi[1])) - 1;
        default:
            return max(max(mag(xi[0]), mag(xi[1])), mag(xi[2])) - 1;
    }
}


//- Move it to the nearest place inside, along the axes or towards the centre
void clamp(const elementShape shape, scalar* xi)
{
    const auto simplex = [&](const label n)
    {
        scalar sum = 0;
        for (label a = 0; a < n; ++a) sum += xi[a] = max(xi[a], scalar(0));
        if (sum > 1) for (label a = 0; a < n; ++a) xi[a] /= sum;
    };
    const auto within = [&](const label from, const label to, const scalar most)
    {
        for (label a = from; a < to; ++a) xi[a] = min(max(xi[a], -most), most);
    };
    switch (shape)
    {
        case elementShape::TRI: simplex(2); break;
        case elementShape::TET: simplex(3); break;
        case elementShape::PRISM: simplex(2); within(2, 3, 1); break;
        case elementShape::PYRAMID:
            xi[2] = min(max(xi[2], scalar(0)), scalar(1));
            within(0, 2, 1 - xi[2]);
            break;
        case elementShape::QUAD: within(0, 2, 1); break;
        default: within(0, 3, 1);
    }
}


//- Newton's method for x(xi) = x; whether it converges
template<class E>
bool invert(const Vec<double, E::dim>* xe, const Vec<double, E::dim>& x, const scalar size, scalar* xi)
{
    constexpr int d = E::dim;
    for (int a = 0; a < d; ++a) xi[a] = d == 2 ? 1.0/3 : 0.25;
    double N[E::nNodes], dN[E::nNodes][d];
    for (label iteration = 0; iteration < 30; ++iteration)
    {
        E::shape(xi, N, dN);
        Vec<double, d> r = x;
        Ten<double, d> J = Ten<double, d>::zero();
        for (int i = 0; i < E::nNodes; ++i)
        {
            r -= N[i]*xe[i];
            for (int a = 0; a < d; ++a) for (int b = 0; b < d; ++b) J(a, b) += xe[i][a]*dN[i][b];
        }
        const scalar detJ = det(J);
        if (!(detJ > 0)) return false;
        const Vec<double, d> step = inv(J, detJ) & r;
        scalar most = 0;
        for (int a = 0; a < d; ++a)
        {
            xi[a] += step[a];
            most = max(most, mag(step[a]));
        }
        if (!(most < 10)) return false;
        if (most < 1e-14 || (most < 1e-8 && Foam::sqrt(r & r) < 1e-15*size)) return true;
        if (E::order == 1 && E::nNodes == d + 1 && iteration) return true;
    }
    return false;
}


template<class E>
Vec<double, E::dim> position(const Vec<double, E::dim>* xe, const scalar* xi)
{
    double N[E::nNodes], dN[E::nNodes][E::dim];
    E::shape(xi, N, dN);
    Vec<double, E::dim> x = Vec<double, E::dim>::zero();
    for (int i = 0; i < E::nNodes; ++i) x += N[i]*xe[i];
    return x;
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::point Foam::elementSearch::flat(const point& p) const
{
    point q(p);
    if (fe_.dim() == 2) q[fe_.axis(2)] = 0;
    return q;
}


void Foam::elementSearch::improve(const point& p, const labelPair& element, place& best) const
{
    const elementBlock& block = fe_.blocks()[element.first()];
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        constexpr int d = E::dim;
        if (d != fe_.dim()) return;
        Vec<double, d> xe[E::nNodes], x;
        for (int a = 0; a < d; ++a) x[a] = p[fe_.axis(a)];
        scalar size = 0;
        for (int i = 0; i < E::nNodes; ++i)
        {
            for (int a = 0; a < d; ++a) xe[i][a] = x_[block.element(element.second())[i]][fe_.axis(a)];
            if (i) size = max(size, Foam::sqrt((xe[i] - xe[0]) & (xe[i] - xe[0])));
        }
        place now;
        now.block = element.first();
        now.element = element.second();
        if (!invert<E>(xe, x, size, now.xi.data())) return;
        now.moved = 0;
        if (excess(block.shape, now.xi.cdata()) > 1e-9)
        {
            clamp(block.shape, now.xi.data());
            const Vec<double, d> r = x - position<E>(xe, now.xi.cdata());
            now.moved = Foam::sqrt(r & r)/size;
        }
        if (now.moved < best.moved) best = now;
    });
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::elementSearch::elementSearch(const feMesh& fe, const vectorField& x)
:
    fe_(fe),
    x_(x)
{
    DynamicList<treeBoundBox> boxes;
    treeBoundBox all;
    forAll(fe.blocks(), b)
    {
        const elementBlock& block = fe.blocks()[b];
        for (label e = 0; e < block.size(); ++e)
        {
            boundBox box;
            for (label i = 0; i < block.nNodes; ++i) box.add(flat(x[block.element(e)[i]]));

            // A curved side may reach beyond its nodes
            const scalar more = (block.order == 1 ? 1e-6 : 0.15)*box.mag();
            const vector margin(more, more, more);
            boxes.append(treeBoundBox(box.min() - margin, box.max() + margin));
            all.add(boxes.last());
            elements_.append(labelPair(b, e));
        }
    }
    if (boxes.empty()) return;
    const vector margin(vector::uniform(1e-3*all.mag()));
    tree_.reset
    (
        new indexedOctree<treeDataElement>
        (
            treeDataElement(boxes), treeBoundBox(all.min() - margin, all.max() + margin), 10, 8, 8
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::elementSearch::place Foam::elementSearch::find(const point& p, const scalar tolerance) const
{
    place best;
    if (!tree_.valid()) return best;
    const point x(flat(p));
    const treeDataElement& data = tree_->shapes();
    for (const label i : tree_->findIndices(x))
    {
        if (data.box(i).contains(x)) improve(x, elements_[i], best);
        if (best.moved == 0) return best;
    }

    // In none: ever larger boxes around it, up to that of the mesh
    const treeBoundBox& all = tree_->bb();
    for (scalar r = 1e-3*all.mag(); r < 2*all.mag(); r *= 2)
    {
        const labelList near(tree_->findBox(treeBoundBox(x - vector::uniform(r), x + vector::uniform(r))));
        for (const label i : near) improve(x, elements_[i], best);
        if (!near.empty()) break;
    }
    if (best.moved > tolerance) best.block = -1;
    return best;
}


void Foam::elementSearch::weights(const place& p, labelList& nodes, scalarList& N) const
{
    const elementBlock& block = fe_.blocks()[p.block];
    nodes = SubList<label>(block.nodes, block.nNodes, p.element*block.nNodes);
    N.setSize(block.nNodes);
    withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        double dN[E::nNodes][E::dim];
        E::shape(p.xi.cdata(), N.data(), dN);
    });
}


void Foam::elementSearch::vertexWeights(const place& p, labelList& nodes, scalarList& N) const
{
    const elementBlock& block = fe_.blocks()[p.block];
    withElement(block, [&](auto tag)
    {
        typedef typename decltype(tag)::Linear L;
        double dN[L::nNodes][L::dim];
        nodes = SubList<label>(block.nodes, L::nNodes, p.element*block.nNodes);
        N.setSize(L::nNodes);
        L::shape(p.xi.cdata(), N.data(), dN);
    });
}


// ************************************************************************* //
