/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mortarWeights.H"
#include "addToRunTimeSelectionTable.H"
#include "facePoints.H"
#include "gatherAll.H"
#include "LUscalarMatrix.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(mortarWeights, 0);
    addToRunTimeSelectionTable(interfaceWeights, mortarWeights, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Test functions chi_i = sum_j T_ij N_j of the nodes i that are not held. Of
//  N_j of held nodes each has the part T_ij with which a field that is linear in xi would
//  be extrapolated, u_j = sum_i T_ij u_i
template<class F>
static scalarSquareMatrix testFunctions(const bool* isHeld)
{
    scalarSquareMatrix T(F::nNodes, Zero);
    const auto at = [](const int i) { return vector(F::xi[i][0], F::dim > 1 ? F::xi[i][F::dim - 1] : 0, 0); };
    vector mean = Zero;
    label nFree = 0;
    for (int i = 0; i < F::nNodes; ++i) if (!isHeld[i])
    {
        T(i, i) = 1;
        mean += at(i);
        ++nFree;
    }
    if (!nFree) return T;
    mean /= nFree;
    symmTensor C = Zero;
    for (int i = 0; i < F::nNodes; ++i) if (!isHeld[i]) C += sqr(at(i) - mean);
    if (F::dim == 1) C.yy() = 1;
    C.zz() = 1;
    const bool linear = det(C) > 1e-6;
    for (int j = 0; j < F::nNodes; ++j) if (isHeld[j])
    {
        const vector g(linear ? vector(inv(C) & (at(j) - mean)) : vector::zero);
        for (int i = 0; i < F::nNodes; ++i) if (!isHeld[i]) T(i, j) = 1.0/nFree + ((at(i) - mean) & g);
    }
    return T;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::mortarWeights::held(const interfaceFit& fit)
{
    const feMesh& fe = fit.region().fe();
    scalarField is(fe.nNodes(), 0);
    forAll(fe.mesh().boundaryMesh(), patchi)
    {
        if (fit.patches().found(patchi)) continue;
        for (const label n : fe.patchNodes(patchi)) is[n] = 1;
    }
    for (const label patchi : fit.patches()) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        for (label f = 0; f < block.size(); ++f)
        {
            const SubList<label> nodes(block.nodes, block.nNodes, f*block.nNodes);
            bool bare = false;
            for (const label n : nodes) bare = bare || fit.isBare(n);
            if (bare) for (const label n : nodes) is[n] = 1;
        }
    }
    fe.copies().maximum(is);
    boolList held(is.size());
    forAll(held, n) held[n] = is[n] > 0;
    return held;
}


template<class F>
void Foam::mortarWeights::addFace
(
    const label* nodes,
    const interfaceFit& fit,
    const Map<List<term>>& given,
    DynamicList<contribution>& contributions,
    DynamicList<corner>& corners
)
{
    constexpr int n = F::nNodes;
    bool isHeld[n], all = true, bare = false;
    for (int i = 0; i < n; ++i)
    {
        isHeld[i] = given.found(nodes[i]);
        all = all && isHeld[i];
        bare = bare || fit.isBare(nodes[i]);
    }
    if (bare) return;

    const interfaceSurface& other = fit.partner();
    point X[n], centre = Zero;
    scalar size = 0;
    for (int i = 0; i < n; ++i)
    {
        X[i] = other.flat(fit.x()[nodes[i]]);
        centre += X[i]/n;
        size = max(size, mag(X[i] - X[0]));
    }
    const scalar ratio = size/other.size(other.project(centre).face);

    scalarSquareMatrix M(n, Zero);
    scalarField a(n, 0);
    List<DynamicList<term>> Nu(n);
    scalar area = 0;
    forPoints<F>(X, other, ratio, [&](const double* xi, const scalar w, const auto& p)
    {
        double N[n], dN[n][F::dim];
        F::shape(xi, N, dN);
        const scalar dA = w*measure<F>(X, dN);
        area += dA;
        point at = Zero;
        for (int i = 0; i < n; ++i) at += N[i]*X[i];
        for (int i = 0; i < n; ++i)
        {
            a[i] += N[i]*dA;
            for (int j = 0; j < n; ++j) M(i, j) += N[i]*N[j]*dA;
            other.addTerms(p, at, N[i]*dA, Nu[i]);
        }
    });
    if (all)
    {
        DynamicList<term> missing;
        corner c;
        for (int i = 0; i < n; ++i)
        {
            missing.append(Nu[i]);
            for (const term& t : given[nodes[i]]) missing.append({t.node, -a[i]*t.weight});
            if (i < F::nVertices) c.vertices.append(fit.region().fe().key()[nodes[i]]);
        }
        c.terms = summed(missing);
        corners.append(c);
        return;
    }
    if (min(a) < 1e-3*area/n) a = area/n;

    // A u = b: int chi_i u_h = int chi_i u, and at held nodes u_h = u
    const scalarSquareMatrix T(testFunctions<F>(isHeld));
    scalarSquareMatrix A(n, Zero);
    List<List<term>> b(n);
    for (int i = 0; i < n; ++i)
    {
        DynamicList<term> sum;
        if (isHeld[i])
        {
            A(i, i) = 1;
            sum = given[nodes[i]];
        }
        else for (int j = 0; j < n; ++j)
        {
            for (int k = 0; k < n; ++k) A(i, k) += T(i, j)*M(j, k);
            for (const term& t : Nu[j]) sum.append({t.node, T(i, j)*t.weight});
        }
        b[i] = summed(sum);
    }
    scalarSquareMatrix inverse(n);
    LUscalarMatrix(A).inv(inverse);
    for (int i = 0; i < n; ++i)
    {
        DynamicList<term> terms;
        for (int j = 0; j < n; ++j) for (const term& t : b[j])
        {
            terms.append({t.node, a[i]*inverse(i, j)*t.weight});
        }
        contributions.append({nodes[i], a[i], summed(terms)});
    }
}


Foam::List<Foam::mortarWeights::corner> Foam::mortarWeights::ofAllRanks(const UList<corner>& mine)
{
    DynamicList<label> labels;
    DynamicList<scalar> weights;
    for (const corner& c : mine)
    {
        labels.append(c.vertices.size());
        labels.append(c.vertices);
        labels.append(c.terms.size());
        for (const term& t : c.terms)
        {
            labels.append(t.node);
            weights.append(t.weight);
        }
    }
    const labelList allLabels(gatherAll<label>(labels));
    const scalarList allWeights(gatherAll<scalar>(weights));
    DynamicList<corner> all;
    for (label l = 0, w = 0; l < allLabels.size();)
    {
        corner c;
        c.vertices = SubList<label>(allLabels, allLabels[l], l + 1);
        l += 1 + c.vertices.size();
        c.terms.setSize(allLabels[l++]);
        for (term& t : c.terms) t = {allLabels[l++], allWeights[w++]};
        all.append(c);
    }
    return all;
}


void Foam::mortarWeights::addCorners
(
    const interfaceFit& fit,
    const Map<List<term>>& given,
    const UList<corner>& mine,
    DynamicList<contribution>& contributions
)
{
    const List<corner> corners(ofAllRanks(mine));
    if (corners.empty()) return;

    // Faces with free nodes that have two vertices of a corner, on any rank
    struct beside { label corner; labelList free; };
    DynamicList<beside> faces;
    labelList nFaces(corners.size(), 0);
    const feMesh& fe = fit.region().fe();
    for (const label patchi : fit.patches()) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        for (label f = 0; f < block.size(); ++f)
        {
            const SubList<label> nodes(block.nodes, block.nNodes, f*block.nNodes);
            beside b;
            for (const label n : nodes) if (!given.found(n)) b.free.append(n);
            if (b.free.empty()) continue;
            forAll(corners, c)
            {
                label nCommon = 0;
                for (label i = 0; i < block.nVertices(); ++i) nCommon += corners[c].vertices.found(fe.key()[nodes[i]]);
                if (nCommon != 2) continue;
                b.corner = c;
                faces.append(b);
                ++nFaces[c];
            }
        }
    }
    Pstream::listCombineGather(nFaces, plusEqOp<label>());
    Pstream::listCombineScatter(nFaces);
    for (const beside& b : faces) for (const label n : b.free)
    {
        contribution c{n, 0, corners[b.corner].terms};
        for (term& t : c.terms) t.weight /= nFaces[b.corner]*b.free.size();
        contributions.append(c);
    }
}


Foam::List<Foam::mortarWeights::contribution> Foam::mortarWeights::ofAllRanks
(
    const feMesh& fe,
    const List<contribution>& mine
)
{
    if (!Pstream::parRun()) return mine;
    Map<label> nodeOf;
    forAll(fe.copies().neighbours(), i) for (const label n : fe.copies().shared(i)) nodeOf.set(fe.key()[n], n);

    // Of nodes that others have: to all, in the same order
    DynamicList<contribution> all;
    DynamicList<label> labels;
    DynamicList<scalar> scalars;
    for (const contribution& c : mine)
    {
        if (!nodeOf.found(fe.key()[c.node]))
        {
            all.append(c);
            continue;
        }
        labels.append(fe.key()[c.node]);
        labels.append(c.terms.size());
        scalars.append(c.a);
        for (const term& t : c.terms)
        {
            labels.append(t.node);
            scalars.append(t.weight);
        }
    }
    const labelList allLabels(gatherAll<label>(labels));
    const scalarList allScalars(gatherAll<scalar>(scalars));
    for (label l = 0, s = 0; l < allLabels.size();)
    {
        const auto found = nodeOf.cfind(allLabels[l]);
        contribution c{found.found() ? *found : -1, allScalars[s++], List<term>(allLabels[l + 1])};
        l += 2;
        for (term& t : c.terms) t = {allLabels[l++], allScalars[s++]};
        if (c.node >= 0) all.append(c);
    }
    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::List<Foam::interfaceSurface::term>> Foam::mortarWeights::rows
(
    const interfaceFit& fit,
    const labelUList& nodes
) const
{
    List<List<term>> rows(interpolationWeights::rows(fit, nodes));
    const feMesh& fe = fit.region().fe();
    const boolList interpolates(held(fit));
    Map<List<term>> given;
    Map<label> place;
    forAll(nodes, i)
    {
        if (interpolates[nodes[i]]) given.insert(nodes[i], rows[i]);
        else place.insert(nodes[i], i);
    }

    DynamicList<contribution> mine;
    DynamicList<corner> corners;
    for (const label patchi : fit.patches()) for (const elementBlock& block : fe.patchBlocks(patchi))
    {
        withFaceElement(block, [&](auto tag)
        {
            for (label f = 0; f < block.size(); ++f)
            {
                addFace<decltype(tag)>(block.element(f), fit, given, mine, corners);
            }
        });
    }
    addCorners(fit, given, corners, mine);

    List<DynamicList<term>> sums(nodes.size());
    scalarField a(nodes.size(), 0);
    for (const contribution& c : ofAllRanks(fe, mine))
    {
        const auto found = place.cfind(c.node);
        if (!found.found()) continue;
        a[*found] += c.a;
        sums[*found].append(c.terms);
    }
    forAll(nodes, i)
    {
        if (sums[i].empty()) continue;
        for (term& t : sums[i]) t.weight /= a[i];
        rows[i] = collected(sums[i]);
    }
    return rows;
}


// ************************************************************************* //
