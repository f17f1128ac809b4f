/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceFit.H"
#include "feValues.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::interfaceFit::nodeSizes() const
{
    const feMesh& fe = region_.fe();
    tmp<scalarField> tsize(new scalarField(fe.nNodes(), 0));
    for (const label patchi : patches_) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        for (label f = 0; f < block.size(); ++f)
        {
            const SubList<label> nodes(block.nodes, block.nNodes, f*block.nNodes);
            scalar size = 0;
            for (const label n : nodes) size = max(size, mag(x_[n] - x_[nodes[0]]));
            for (const label n : nodes) tsize.ref()[n] = max(tsize()[n], size);
        }
    }
    fe.copies().maximum(tsize.ref());
    return tsize;
}


bool Foam::interfaceFit::isGap(const interfaceSurface::projection& p, const scalar size) const
{
    return p.face < 0 || p.distance > tolerance_*max(size, partner_.size(p.face));
}


void Foam::interfaceFit::measureNodes()
{
    const feMesh& fe = region_.fe();
    const scalarField size(nodeSizes());
    labelHashSet nodes;
    for (const label patchi : patches_) nodes.insert(fe.patchNodes(patchi));
    for (const label n : nodes)
    {
        const interfaceSurface::projection p(partner_.project(x_[n]));
        bare_[n] = isGap(p, size[n]);
        if (!fe.copies().owned(n)) continue;
        ++nNodes;
        if (bare_[n]) ++nGaps;
        if (p.distance < largestGap) continue;
        largestGap = p.distance;
        where = x_[n];
    }
    reduce(nNodes, sumOp<label>());
    reduce(nGaps, sumOp<label>());
    const scalar mine = largestGap;
    reduce(largestGap, maxOp<scalar>());
    if (mine < largestGap) where = point::max;
    reduce(where, minOp<point>());
}


template<class Call>
void Foam::interfaceFit::forPoints(const Call& f) const
{
    const feMesh& fe = region_.fe();
    for (const label patchi : patches_) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto tag)
        {
            typedef decltype(tag) F;
            faceValues<double, F> face;
            Vec<double, face.dim> x[F::nNodes];
            if (face.dim != fe.dim()) return;
            for (label e = 0; e < block.size(); ++e)
            {
                const label* n = block.element(e);
                scalar size = 0;
                for (int i = 0; i < F::nNodes; ++i)
                {
                    for (int a = 0; a < face.dim; ++a) x[i][a] = x_[n[i]][fe.axis(a)];
                    size = max(size, mag(x_[n[i]] - x_[n[0]]));
                }
                for (int q = 0; q < face.nQ; ++q)
                {
                    face.reinit(x, q);
                    point at = Zero;
                    vector ndA = Zero;
                    for (int a = 0; a < face.dim; ++a)
                    {
                        at[fe.axis(a)] = face.value(x)[a];
                        ndA[fe.axis(a)] = face.ndA[a];
                    }
                    f(face, n, at, ndA, size);
                }
            }
        });
    }
}


void Foam::interfaceFit::measureFaces()
{
    forPoints([&](const auto&, const label*, const point& at, const vector& ndA, const scalar size)
    {
        area += mag(ndA);
        const interfaceSurface::projection p(partner_.project(at));
        if (isGap(p, size)) uncovered += mag(ndA);
        else if ((p.n & ndA) > 0) wrongWay += mag(ndA);
    });
    for (scalar* sum : {&area, &uncovered, &wrongWay}) reduce(*sum, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::interfaceFit::interfaceFit
(
    const feRegion& region,
    const labelUList& patches,
    const vectorField& x,
    const interfaceSurface& partner,
    const scalar tolerance
)
:
    region_(region),
    patches_(patches),
    x_(x),
    partner_(partner),
    tolerance_(tolerance),
    bare_(region.fe().nNodes(), false)
{
    measureNodes();
    measureFaces();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::interfaceFit::leakage(const vectorField& v, const vectorField& vPartner) const
{
    const vectorField partners(partner_.gathered(vPartner));
    scalar sum = 0;
    forPoints([&](const auto& face, const label* n, const point& at, const vector& ndA, const scalar size)
    {
        const interfaceSurface::projection p(partner_.project(at));
        if (isGap(p, size)) return;
        vector difference = -partner_.value(p, partners);
        for (int i = 0; i < face.n; ++i) difference += face.N[i]*v[n[i]];
        sum += difference & ndA;
    });
    return returnReduce(sum, sumOp<scalar>());
}


// ************************************************************************* //
