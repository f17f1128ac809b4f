/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalBoundary.H"
#include "feValues.H"
#include "basicSymmetryPointPatchField.H"
#include "slipPointPatchField.H"
#include "symmetryPlanePointPatchField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::nodalBoundary::isSlip(const word& type)
{
    return type == "slip" || type == "symmetry" || type == "symmetryPlane";
}


Foam::tmp<Foam::vectorField> Foam::nodalBoundary::normals
(
    const label patchi,
    const labelUList& systemNode,
    const nodeMap& map
) const
{
    tmp<vectorField> tn(new vectorField(fe_.nNodes(), Zero));
    vectorField& n = tn.ref();

    for (const elementBlock& block : fe_.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto tag)
        {
            typedef decltype(tag) F;
            faceValues<double, F> face;
            Vec<double, face.dim> x[F::nNodes];
            if (face.dim != fe_.dim()) return;
            for (label e = 0; e < block.size(); ++e)
            {
                const label* nodes = block.element(e);
                for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < face.dim; ++a)
                {
                    x[i][a] = fe_.points()[nodes[i]][fe_.axis(a)];
                }
                for (int q = 0; q < face.nQ; ++q)
                {
                    face.reinit(x, q);
                    for (int i = 0; i < F::nNodes; ++i) for (int a = 0; a < face.dim; ++a)
                    {
                        // Of all faces at the node alike: vertices of order 2
                        // have shape functions of mean zero on triangles
                        n[nodes[i]][fe_.axis(a)] += face.ndA[a];
                    }
                }
            }
        });
    }

    // The copies of a node see different faces
    for (label a = 0; a < fe_.dim(); ++a)
    {
        scalarField na(map.nUnknowns(), 0);
        forAll(n, i) if (map.nUnknowns(systemNode[i])) na[map.start(systemNode[i])] = n[i][fe_.axis(a)];
        map.sum(na);
        forAll(n, i) if (map.nUnknowns(systemNode[i])) n[i][fe_.axis(a)] = na[map.start(systemNode[i])];
    }
    return tn;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nodalBoundary::constrain
(
    const pointVectorField& field,
    const labelUList& systemNode,
    const nodeMap& map,
    dofConstraints& c
) const
{
    const label dim = fe_.dim();

    // Orthonormal normals of the slip patches met at each node
    List<DynamicList<vector>> slip(fe_.nNodes());
    forAll(field.boundaryField(), patchi)
    {
        if (!isSlip(field.boundaryField()[patchi].type())) continue;
        const vectorField n(normals(patchi, systemNode, map));
        forAll(n, i)
        {
            if (mag(n[i]) < VSMALL) continue;
            vector u = n[i]/mag(n[i]);
            for (const vector& v : slip[i]) u -= (u & v)*v;
            if (mag(u) > 1e-3) slip[i].append(u/mag(u));
        }
    }

    forAll(slip, i)
    {
        const label start = map.start(systemNode[i]), nSlip = slip[i].size();
        if (!nSlip) continue;

        const auto cmpt = [&](const vector& v, const label a) { return v[fe_.axis(a)]; };
        const auto largest = [&](const vector& v)
        {
            label k = 0;
            for (label a = 1; a < dim; ++a) if (mag(cmpt(v, a)) > mag(cmpt(v, k))) k = a;
            return k;
        };
        if (nSlip >= dim)
        {
            for (label a = 0; a < dim; ++a) c.fix(start + a);
        }
        else if (nSlip == 1)
        {
            // u_k = -sum_a n_a u_a/n_k
            const vector& n = slip[i][0];
            const label k = largest(n);
            DynamicList<dofConstraints::term> row;
            for (label a = 0; a < dim; ++a)
            {
                const scalar w = -cmpt(n, a)/cmpt(n, k);
                if (a != k && mag(w) > 1e-10) row.append({start + a, w});
            }
            if (row.empty()) c.fix(start + k);
            else c.tie(start + k, row);
        }
        else
        {
            // On the line of two planes: u_a = t_a u_k/t_k
            const vector t = slip[i][0] ^ slip[i][1];
            const label k = largest(t);
            for (label a = 0; a < dim; ++a)
            {
                if (a == k) continue;
                const scalar w = cmpt(t, a)/cmpt(t, k);
                if (mag(w) < 1e-10) c.fix(start + a);
                else c.tie(start + a, List<dofConstraints::term>(1, dofConstraints::term{start + k, w}));
            }
        }
    }

    for (const label n : fixedNodes(field))
    {
        for (label a = 0; a < dim; ++a) c.fix(map.start(systemNode[n]) + a);
    }
}


void Foam::nodalBoundary::constrain
(
    const pointScalarField& field,
    const labelUList& systemNode,
    const nodeMap& map,
    const label cmpt,
    dofConstraints& c
) const
{
    for (const label n : fixedNodes(field))
    {
        if (map.nUnknowns(systemNode[n]) > cmpt) c.fix(map.start(systemNode[n]) + cmpt);
    }
}


// ************************************************************************* //
