/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "flowSystem.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "ListOps.H"

#include <algorithm>
#include <cmath>
#include <vector>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::flowSystem::power(const label base) const
{
    return p_.nDims == 2 ? base*base : base*base*base;
}


Foam::labelList Foam::flowSystem::indices(label number, const label n) const
{
    labelList ijk(p_.nDims);
    for (label& i : ijk)
    {
        i = number % n;
        number /= n;
    }
    return ijk;
}


bool Foam::flowSystem::corner(const labelList& ijk) const
{
    bool result = true;
    for (const label i : ijk)
    {
        result = result && i % p_.order == 0;
    }
    return result;
}


bool Foam::flowSystem::fixed(const labelList& ijk, const label component) const
{
    bool wall = false;
    forAll(ijk, d)
    {
        wall = wall || ijk[d] == 0
            || (ijk[d] == nEdge_ - 1 && (d > 0 || p_.closed));
    }
    return wall && component < p_.nDims;
}


void Foam::flowSystem::shape
(
    const label order,
    const scalar xi,
    scalar* N,
    scalar* dN
)
{
    if (order == 1)
    {
        N[0] = 1 - xi;
        N[1] = xi;
        dN[0] = -1;
        dN[1] = 1;
        return;
    }
    N[0] = (1 - xi)*(1 - 2*xi);
    N[1] = 4*xi*(1 - xi);
    N[2] = xi*(2*xi - 1);
    dN[0] = 4*xi - 3;
    dN[1] = 4 - 8*xi;
    dN[2] = 4*xi - 1;
}


void Foam::flowSystem::numberUnknowns()
{
    const label nNodes = power(nEdge_);
    start_.setSize(nNodes + 1);
    start_[0] = 0;
    for (label node = 0; node < nNodes; ++node)
    {
        const bool p = corner(indices(node, nEdge_));
        start_[node + 1] = start_[node] + p_.nDims + (p ? 1 : 0);
    }

    const label nProcs = Pstream::nProcs(), me = Pstream::myProcNo();
    labelList offsets(nProcs + 1);
    forAll(offsets, proci)
    {
        offsets[proci] = start_[(nNodes*proci)/nProcs];
    }
    pattern.unknowns = globalIndex(offsets);

    const label first = (nNodes*me)/nProcs, end = (nNodes*(me + 1))/nProcs;
    pattern.nodeStart = SubList<label>(start_, end - first, first);

    const label nLocal = power(p_.order + 1);
    for (label node = 0; node < nLocal; ++node)
    {
        const bool p = corner(indices(node, p_.order + 1));
        for (label c = 0; c < p_.nDims + (p ? 1 : 0); ++c)
        {
            localNode_.append(node);
            component_.append(c);
        }
    }
}


void Foam::flowSystem::addPoint(const labelList& gaussPoint)
{
    const scalar g = std::sqrt(0.6)/2;
    const scalar abscissa[] = {0.5 - g, 0.5, 0.5 + g};
    const scalar weight[] = {5.0/18, 8.0/18, 5.0/18};
    const scalar c[] = {1, 0.5, 0.25};
    const scalar h = 1.0/p_.nElements;
    const label nDims = p_.nDims, n = localNode_.size();

    scalar dV = 1;
    std::vector<scalar> N(n, 1), cdN(n, 0), dN(n*nDims, 1);

    for (label a = 0; a < n; ++a)
    {
        const bool p = component_[a] == nDims;
        const label order = p ? 1 : p_.order;
        const labelList ijk(indices(localNode_[a], p_.order + 1));

        for (label d = 0; d < nDims; ++d)
        {
            scalar N1[3], dN1[3];
            shape(order, abscissa[gaussPoint[d]], N1, dN1);
            const label i = p ? ijk[d]/p_.order : ijk[d];
            N[a] *= N1[i];
            for (label e = 0; e < nDims; ++e)
            {
                dN[a*nDims + e] *= (e == d ? dN1[i]/h : N1[i]);
            }
        }
        for (label d = 0; d < nDims; ++d)
        {
            cdN[a] += c[d]*dN[a*nDims + d];
        }
    }
    for (label d = 0; d < nDims; ++d)
    {
        dV *= h*weight[gaussPoint[d]];
    }

    const scalar tau = p_.order == 1
      ? 1/(p_.rhoByDt + 2*p_.rho/h + 12*p_.mu/(h*h)) : 0;

    for (label a = 0; a < n; ++a)
    {
        for (label b = 0; b < n; ++b)
        {
            const scalar* dNa = &dN[a*nDims];
            const scalar* dNb = &dN[b*nDims];
            const label ca = component_[a], cb = component_[b];
            scalar laplacian = 0;
            for (label d = 0; d < nDims; ++d)
            {
                laplacian += dNa[d]*dNb[d];
            }

            scalar k = 0;
            if (ca < nDims && ca == cb)
            {
                k = N[a]*(p_.rhoByDt*N[b] + p_.rho*cdN[b]) + p_.mu*laplacian;
            }
            else if (ca < nDims && cb == nDims)
            {
                k = -dNa[ca]*N[b];
            }
            else if (ca == nDims && cb < nDims)
            {
                k = N[a]*dNb[cb];
            }
            else if (ca == nDims)
            {
                k = tau*laplacian;
            }
            element_[a*n + b] += k*dV;
        }
    }
}


void Foam::flowSystem::integrate()
{
    element_.setSize(localNode_.size()*localNode_.size(), scalar(0));
    for (label point = 0; point < power(3); ++point)
    {
        addPoint(indices(point, 3));
    }
}


void Foam::flowSystem::assemble()
{
    const label n = localNode_.size();
    DynamicList<label> row, col;
    DynamicList<scalar> value;
    labelList unknown(n);
    boolList given(n);

    for (label element = 0; element < power(p_.nElements); ++element)
    {
        const labelList first(indices(element, p_.nElements));

        forAll(unknown, a)
        {
            labelList ijk(indices(localNode_[a], p_.order + 1));
            label node = 0;
            for (label d = p_.nDims - 1; d >= 0; --d)
            {
                ijk[d] += p_.order*first[d];
                node = node*nEdge_ + ijk[d];
            }
            unknown[a] = start_[node] + component_[a];
            given[a] = fixed(ijk, component_[a]);
        }

        if (!pattern.unknowns.isLocal(unknown[0]))
        {
            continue;
        }

        for (label a = 0; a < n; ++a)
        {
            for (label b = 0; b < n; ++b)
            {
                const bool couples =
                    a == b
                 || (
                        !given[a] && !given[b]
                     && (
                            component_[a] == component_[b]
                         || component_[a] == p_.nDims
                         || component_[b] == p_.nDims
                        )
                    );

                if (couples)
                {
                    row.append(unknown[a]);
                    col.append(unknown[b]);
                    value.append
                    (
                        given[a] ? 1.0 : element_[a*n + b]
                    );
                }
            }
        }
    }

    pattern.row.transfer(row);
    pattern.col.transfer(col);
    values.transfer(value);
}


void Foam::flowSystem::merge()
{
    const label n = pattern.row.size();
    labelList order(identity(n));
    const labelList& row = pattern.row;
    const labelList& col = pattern.col;
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return row[a] != row[b] ? row[a] < row[b] : col[a] < col[b];
        }
    );

    DynamicList<label> newRow, newCol;
    DynamicList<scalar> newValue;
    for (const label k : order)
    {
        if (newRow.size() && newRow.last() == row[k] && newCol.last() == col[k])
        {
            newValue.last() += values[k];
        }
        else
        {
            newRow.append(row[k]);
            newCol.append(col[k]);
            newValue.append(values[k]);
        }
    }
    pattern.row.transfer(newRow);
    pattern.col.transfer(newCol);
    values.transfer(newValue);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::flowSystem::flowSystem(const parameters& p)
:
    p_(p),
    nEdge_(p.order*p.nElements + 1)
{
    numberUnknowns();
    integrate();
    assemble();
    if (p.assembled)
    {
        merge();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::flowSystem::product(const scalarField& x) const
{
    const globalIndex& unknowns = pattern.unknowns;
    const label first = unknowns.localStart();

    scalarField all(unknowns.size(), Zero), result(all);
    forAll(x, i)
    {
        all[first + i] = x[i];
    }
    Pstream::listCombineGather(all, plusEqOp<scalar>());
    Pstream::listCombineScatter(all);

    forAll(values, k)
    {
        result[pattern.row[k]] += values[k]*all[pattern.col[k]];
    }
    Pstream::listCombineGather(result, plusEqOp<scalar>());
    Pstream::listCombineScatter(result);

    return scalarField(SubList<scalar>(result, x.size(), first));
}


Foam::scalarField Foam::flowSystem::manufactured() const
{
    scalarField x(pattern.unknowns.localSize());
    forAll(x, i)
    {
        x[i] = 1 + std::sin(1.7*pattern.unknowns.toGlobal(i));
    }
    return x;
}


// ************************************************************************* //
