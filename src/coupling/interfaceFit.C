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


void Foam::interfaceFit::measureNodes()
{
    const feMesh& fe = region_.fe();
    const scalarField size(nodeSizes());
    for (const label patchi : patches_) for (const label n : fe.patchNodes(patchi))
    {
        if (!fe.copies().owned(n)) continue;
        ++nNodes;
        const interfaceSurface::projection p(partner_.project(x_[n]));
        if (p.face < 0 || p.distance > tolerance_*max(size[n], partner_.size(p.face))) ++nGaps;
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


void Foam::interfaceFit::measureFaces()
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
                    area += mag(ndA);
                    const interfaceSurface::projection p(partner_.project(at));
                    if (p.face < 0 || p.distance > tolerance_*max(size, partner_.size(p.face)))
                    {
                        uncovered += mag(ndA);
                    }
                    else if ((p.n & ndA) > 0) wrongWay += mag(ndA);
                }
            }
        });
    }
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
    tolerance_(tolerance)
{
    measureNodes();
    measureFaces();
}


// ************************************************************************* //
