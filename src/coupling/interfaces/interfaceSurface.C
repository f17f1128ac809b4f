/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceSurface.H"
#include "nearestOnFace.H"
#include "gatherAll.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Call f(face element) of a shape and order
template<class F>
static void withFace(const elementShape shape, const label order, F&& f)
{
    elementBlock kind;
    kind.shape = shape;
    kind.order = order;
    withFaceElement(kind, f);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::interfaceSurface::gather
(
    const labelUList& patches,
    const vectorField& x
)
{
    const polyMesh& mesh = fe_.mesh();
    labelList blockOf(mesh.nCells(), -1), elementOf(blockOf);
    forAll(fe_.blocks(), b) forAll(fe_.blocks()[b].cells, e)
    {
        blockOf[fe_.blocks()[b].cells[e]] = b;
        elementOf[fe_.blocks()[b].cells[e]] = e;
    }

    // Of a face: shape, order, numbers of its nodes and of the vertices behind
    DynamicList<label> kinds, nodes;
    for (const label patchi : patches) for (const elementBlock& block : fe_.patchBlocks(patchi))
    {
        for (label f = 0; f < block.size(); ++f)
        {
            const label celli = mesh.boundaryMesh()[patchi].faceCells()[block.cells[f]];
            const elementBlock& cells = fe_.blocks()[blockOf[celli]];
            const label nBehind = cells.nVertices();
            for (const label k : {label(block.shape), block.order, block.nNodes, nBehind}) kinds.append(k);
            nodes.append(SubList<label>(block.nodes, block.nNodes, f*block.nNodes));
            nodes.append(SubList<label>(cells.nodes, nBehind, elementOf[celli]*cells.nNodes));
        }
    }

    mine_ = labelHashSet(nodes).sortedToc();
    labelList global(mine_);
    for (labelList* list : {&global, static_cast<labelList*>(&nodes)})
    {
        for (label& n : *list) n = numbering_.toGlobal(n);
    }
    numbers_ = gatherAll<label>(global);
    points_ = gathered(x);
    for (point& p : points_) p = flat(p);
    makeFaces(gatherAll<label>(kinds), gatherAll<label>(nodes));
}


void Foam::interfaceSurface::makeFaces(const labelUList& kinds, const labelUList& nodes)
{
    Map<label> place(2*numbers_.size());
    forAll(numbers_, i) place.insert(numbers_[i], i);

    faces_.setSize(kinds.size()/4);
    centres_ = pointField(faces_.size(), Zero);
    largestRadius_ = 0;
    label at = 0;
    const auto take = [&](const label n)
    {
        labelList taken(n);
        for (label& t : taken) t = place[nodes[at++]];
        return taken;
    };
    forAll(faces_, f)
    {
        element& face = faces_[f];
        face.shape = elementShape(kinds[4*f]);
        face.order = kinds[4*f + 1];
        face.nodes = take(kinds[4*f + 2]);
        face.behind = take(kinds[4*f + 3]);

        face.radius = 0;
        for (const label n : face.nodes) centres_[f] += points_[n]/scalar(face.nodes.size());
        for (const label n : face.nodes) face.radius = max(face.radius, mag(points_[n] - centres_[f]));
        largestRadius_ = max(largestRadius_, face.radius);
    }
}


void Foam::interfaceSurface::makeTree()
{
    if (faces_.empty()) return;
    treeBoundBox bb(centres_);
    const vector margin(vector::uniform(largestRadius_ + 1e-3*bb.mag()));
    bb.min() -= margin;
    bb.max() += margin;
    tree_.reset(new indexedOctree<treeDataPoint>(treeDataPoint(centres_), bb, 10, 10, 3));
}


bool Foam::interfaceSurface::before(const projection& p, const projection& q) const
{
    if (q.face < 0) return true;
    const scalar small = 1e-9*max(faces_[p.face].radius, faces_[q.face].radius);
    if (mag(p.distance - q.distance) > small) return p.distance < q.distance;
    const vector d = centres_[p.face] - centres_[q.face];
    for (direction c = 0; c < 3; ++c) if (mag(d[c]) > small) return d[c] < 0;
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceSurface::interfaceSurface
(
    const feRegion& region,
    const labelUList& patches,
    const vectorField& x,
    const bool keepsGaps
)
:
    fe_(region.fe()),
    numbering_(fe_.nNodes()),
    keepsGaps_(keepsGaps)
{
    gather(patches, x);
    makeTree();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::interfaceSurface::flat(point x) const
{
    if (fe_.dim() == 2) x[fe_.axis(2)] = 0;
    return x;
}


Foam::interfaceSurface::projection Foam::interfaceSurface::project(const point& X) const
{
    projection best;
    if (faces_.empty()) return best;

    // The centre of a face is nearly on it; a face may reach further than its circle
    // where it is curved
    const point to(flat(X));
    const scalar reach =
        mag(tree_->findNearest(to, sqr(GREAT)).hitPoint() - to) + 1.1*largestRadius_;
    for (const label f : tree_->findSphere(to, sqr(reach)))
    {
        if (mag(to - centres_[f]) - 1.1*faces_[f].radius > best.distance) continue;
        const projection p(project(f, to));
        if (before(p, best)) best = p;
    }
    return best;
}


Foam::interfaceSurface::projection Foam::interfaceSurface::project
(
    const label facei,
    const point& to
) const
{
    const element& face = faces_[facei];
    projection p;
    p.face = facei;
    withFace(face.shape, face.order, [&](auto tag)
    {
        typedef decltype(tag) F;
        point X[F::nNodes];
        for (int i = 0; i < F::nNodes; ++i) X[i] = points_[face.nodes[i]];
        nearestOnFace<F>(X, to, p.xi);
        vector t[2];
        p.x = evaluate<F>(X, p.xi, t);
        if (F::dim == 1)
        {
            t[1] = Zero;
            t[1][fe_.axis(2)] = 1;
        }
        p.n = t[0] ^ t[1];
        p.n /= mag(p.n);
    });
    p.distance = mag(to - p.x);
    return p;
}


Foam::labelList Foam::interfaceSurface::near(const point& to, const scalar radius) const
{
    if (faces_.empty()) return labelList();
    DynamicList<label> found;
    for (const label f : tree_->findSphere(to, sqr(radius + largestRadius_)))
    {
        if (mag(to - centres_[f]) < radius + faces_[f].radius) found.append(f);
    }
    return found;
}


Foam::pointField Foam::interfaceSurface::vertices(const label facei) const
{
    const element& face = faces_[facei];
    return pointField(points_, SubList<label>(face.nodes, face.shape == elementShape::TRI ? 3 : 4));
}


Foam::tmp<Foam::vectorField> Foam::interfaceSurface::gathered(const vectorField& f) const
{
    return tmp<vectorField>::New(gatherAll<vector>(vectorField(f, mine_)));
}


Foam::vector Foam::interfaceSurface::value(const projection& p, const UList<vector>& f) const
{
    const element& face = faces_[p.face];
    vector v = Zero;
    withFace(face.shape, face.order, [&](auto tag)
    {
        typedef decltype(tag) F;
        double N[F::nNodes], dN[F::nNodes][F::dim];
        F::shape(p.xi, N, dN);
        for (int i = 0; i < F::nNodes; ++i) v += N[i]*f[face.nodes[i]];
    });
    return v;
}


void Foam::interfaceSurface::addTerms
(
    const projection& p,
    const point& X,
    const scalar factor,
    DynamicList<term>& terms
) const
{
    const element& face = faces_[p.face];
    withFace(face.shape, face.order, [&](auto tag)
    {
        typedef decltype(tag) F;
        double N[F::nNodes], dN[F::nNodes][F::dim];
        F::shape(p.xi, N, dN);
        for (int i = 0; i < F::nNodes; ++i) terms.append({numbers_[face.nodes[i]], factor*N[i]});
    });

    const vector gap(flat(X) - p.x);
    if (!keepsGaps_ || mag(gap) < 1e-9*face.radius) return;
    point mean = Zero;
    for (const label j : face.behind) mean += points_[j]/scalar(face.behind.size());
    tensor C = Zero;
    if (fe_.dim() == 2) C(fe_.axis(2), fe_.axis(2)) = 1;
    for (const label j : face.behind) C += (points_[j] - mean)*(points_[j] - mean);
    const vector f(factor*(inv(C) & gap));
    for (const label j : face.behind) terms.append({numbers_[j], (points_[j] - mean) & f});
}


// ************************************************************************* //
