/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feMatrix.H"
#include "SortableList.H"
#include <algorithm>
#include <type_traits>

// * * * * * * * * * * * * * * * elementScatter * * * * * * * * * * * * * * * //

Foam::elementScatter::elementScatter
(
    const elementBlock& block,
    const labelUList& rowNode,
    const labelUList& colNode
)
:
    n(block.nNodes),
    rowNodes(UIndirectList<label>(rowNode, block.nodes)()),
    colNodes(UIndirectList<label>(colNode, block.nodes)()),
    tied(block.size(), false)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::feMatrix::addToGraph
(
    const elementScatter& block,
    List<DynamicList<label>>& graph
) const
{
    for (label e = 0; e < block.nElements(); ++e)
    {
        const label* I = &block.rowNodes[e*block.n];
        const label* J = &block.colNodes[e*block.n];
        if (!block.tied[e])
        {
            for (label i = 0; i < block.n; ++i)
            {
                for (label j = 0; j < block.n; ++j) graph[I[i]].append(J[j]);
            }
            continue;
        }

        // Nodes of the masters join those of the element
        labelHashSet all;
        for (label i = 0; i < block.n; ++i)
        {
            all.insert(I[i]);
            for (label u = rows_.start(I[i]); u < rows_.start(I[i] + 1); ++u)
            {
                if (!constraints_->isTied(u)) continue;
                for (const auto& t : constraints_->masters(u)) all.insert(colNodeOf_[t.unknown]);
            }
        }
        for (const label i : all) for (const label j : all) graph[i].append(j);
    }
}


Foam::label Foam::feMatrix::position
(
    const label rowNode,
    const label colNode
) const
{
    const label* begin = &nodeCol_[nodeStart_[rowNode]];
    const label* end = begin + nodeStart_[rowNode + 1] - nodeStart_[rowNode];
    const label* found = std::lower_bound(begin, end, colNode);
    return nodeOffset_[nodeStart_[rowNode] + (found - begin)];
}


void Foam::feMatrix::addEntry
(
    const label row,
    const label col,
    const scalar value
)
{
    const label I = colNodeOf_[row], J = colNodeOf_[col];
    scalar& v = values_[rowStart_[row] + position(I, J) + col - cols_.start(J)];
    #pragma omp atomic
    v += value;
}


void Foam::feMatrix::addTied
(
    const label row,
    const label col,
    const scalar value
)
{
    const dofConstraints& c = *constraints_;
    const auto addRow = [&](const label r, const scalar v)
    {
        if (!c.isTied(col)) addEntry(r, col, v);
        else for (const auto& t : c.masters(col)) addEntry(r, t.unknown, t.weight*v);
    };
    if (!c.isTied(row)) addRow(row, value);
    else for (const auto& t : c.masters(row)) addRow(t.unknown, t.weight*value);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feMatrix::feMatrix
(
    const nodeMap& rows,
    const nodeMap& cols,
    const dofConstraints* constraints,
    const UPtrList<elementScatter>& blocks
)
:
    rows_(rows),
    cols_(cols),
    constraints_(constraints),
    nodeStart_(rows.nNodes() + 1, 0),
    rowStart_(rows.nUnknowns() + 1, 0),
    colNodeOf_(cols.nUnknowns())
{
    for (label J = 0; J < cols.nNodes(); ++J)
    {
        for (label u = cols.start(J); u < cols.start(J + 1); ++u) colNodeOf_[u] = J;
    }

    List<DynamicList<label>> graph(rows.nNodes());
    forAll(blocks, b)
    {
        elementScatter& block = const_cast<elementScatter&>(blocks[b]);
        block.tied = false;
        if (constraints_)
        {
            forAll(block.rowNodes, k)
            {
                const label I = block.rowNodes[k];
                for (label u = rows.start(I); u < rows.start(I + 1); ++u)
                {
                    if (constraints_->isTied(u)) block.tied[k/block.n] = true;
                }
            }
        }
        addToGraph(block, graph);
    }

    forAll(graph, I)
    {
        std::sort(graph[I].begin(), graph[I].end());
        graph[I].setSize(std::unique(graph[I].begin(), graph[I].end()) - graph[I].begin());
        nodeStart_[I + 1] = nodeStart_[I] + graph[I].size();
    }
    nodeCol_.setSize(nodeStart_.last());
    nodeOffset_.setSize(nodeCol_.size());
    forAll(graph, I)
    {
        label offset = 0;
        forAll(graph[I], k)
        {
            nodeCol_[nodeStart_[I] + k] = graph[I][k];
            nodeOffset_[nodeStart_[I] + k] = offset;
            offset += cols.nUnknowns(graph[I][k]);
        }
        for (label u = rows.start(I); u < rows.start(I + 1); ++u) rowStart_[u + 1] = offset;
    }
    for (label u = 0; u < rows.nUnknowns(); ++u) rowStart_[u + 1] += rowStart_[u];

    col_.setSize(rowStart_.last());
    values_.setSize(col_.size(), 0);
    forAll(graph, I)
    {
        for (label u = rows.start(I); u < rows.start(I + 1); ++u)
        {
            label k = rowStart_[u];
            for (const label J : graph[I])
            {
                for (label v = cols.start(J); v < cols.start(J + 1); ++v) col_[k++] = v;
            }
        }
    }

    forAll(blocks, b)
    {
        elementScatter& block = const_cast<elementScatter&>(blocks[b]);
        const label n = block.n;
        block.position.setSize(block.nElements()*n*n);
        for (label e = 0; e < block.nElements(); ++e)
        {
            for (label i = 0; i < n; ++i) for (label j = 0; j < n; ++j)
            {
                block.position[(e*n + i)*n + j] =
                    position(block.rowNodes[e*n + i], block.colNodes[e*n + j]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feMatrix::add
(
    const elementScatter& scatter,
    const elementBlock& block,
    const label batch,
    const pack* K,
    const int nI, const int nJ,
    const int dRow, const int dCol,
    const int rowCmpt, const int colCmpt,
    const scalar scale
)
{
    const int nLanes = block.nLanes(batch);
    const label n = scatter.n;

    // Lanes with tied unknowns go entry by entry
    label element[packSize];
    const label* position[packSize];
    const label* rowNode[packSize];
    int lane[packSize], tiedLane[packSize], nFree = 0, nTied = 0;
    for (int l = 0; l < nLanes; ++l)
    {
        element[l] = block.lane(batch, l);
        if (scatter.tied[element[l]])
        {
            tiedLane[nTied++] = l;
            continue;
        }
        lane[nFree] = l;
        position[nFree] = &scatter.position[element[l]*n*n];
        rowNode[nFree++] = &scatter.rowNodes[element[l]*n];
    }

    // The loops over components have sizes known to the compiler
    const auto addAs = [&](const auto nRows, const auto nCols)
    {
        constexpr int R = nRows(), C = nCols();
        alignas(64) double entries[R*C*packSize];
        const pack* Kij = K;
        for (int i = 0; i < nI; ++i)
        {
            scalar* row[packSize];
            label length[packSize];
            for (int f = 0; f < nFree; ++f)
            {
                const label u = rows_.start(rowNode[f][i]) + rowCmpt;
                length[f] = rowStart_[u + 1] - rowStart_[u];
                row[f] = values_.begin() + rowStart_[u] + colCmpt;
            }
            for (int j = 0; j < nJ; ++j, Kij += R*C)
            {
                for (int k = 0; k < R*C; ++k)
                {
                    (scale*Kij[k]).copy_to(entries + k*packSize, stdx::vector_aligned);
                }
                for (int f = 0; f < nFree; ++f)
                {
                    scalar* to = row[f] + position[f][i*n + j];
                    const double* from = entries + lane[f];
                    for (int a = 0; a < R; ++a) for (int b = 0; b < C; ++b)
                    {
                        to[a*length[f] + b] += from[(a*C + b)*packSize];
                    }
                }
                for (int t = 0; t < nTied; ++t)
                {
                    const label e = element[tiedLane[t]];
                    const label u = rows_.start(scatter.rowNodes[e*n + i]) + rowCmpt;
                    const label v = cols_.start(scatter.colNodes[e*n + j]) + colCmpt;
                    for (int a = 0; a < R; ++a) for (int b = 0; b < C; ++b)
                    {
                        addTied(u + a, v + b, entries[(a*C + b)*packSize + tiedLane[t]]);
                    }
                }
            }
        }
    };

    const std::integral_constant<int, 1> one;
    const std::integral_constant<int, 2> two;
    const std::integral_constant<int, 3> three;
    switch (10*dRow + dCol)
    {
        case 11: addAs(one, one); break;
        case 12: addAs(one, two); break;
        case 13: addAs(one, three); break;
        case 21: addAs(two, one); break;
        case 22: addAs(two, two); break;
        case 31: addAs(three, one); break;
        case 33: addAs(three, three); break;
        default:
            FatalErrorInFunction
                << "Blocks of " << dRow << " x " << dCol << " components"
                << abort(FatalError);
    }
}


void Foam::feMatrix::add
(
    const label rowNode, const label rowCmpt,
    const label colNode, const label colCmpt,
    const scalar value
)
{
    const label u = rows_.start(rowNode) + rowCmpt, v = cols_.start(colNode) + colCmpt;
    if (constraints_) addTied(u, v, value);
    else addEntry(u, v, value);
}


void Foam::feMatrix::multiply(const scalarField& x, scalarField& y) const
{
    const label n = rows_.nUnknowns();
    #pragma omp parallel for schedule(static)
    for (label u = 0; u < n; ++u)
    {
        scalar s = 0;
        for (label k = rowStart_[u]; k < rowStart_[u + 1]; ++k) s += values_[k]*x[col_[k]];
        y[u] = s;
    }
}


void Foam::feMatrix::triplets(labelList& row, labelList& col)
{
    DynamicList<label> entries, r, c;
    for (label u = 0; u < rows_.nUnknowns(); ++u)
    {
        if (constraints_ && !constraints_->isFree(u))
        {
            // The one equation of a constrained unknown: its increment is nil
            if (rows_.owned(colNodeOf_[u])) { entries.append(-1); r.append(u); c.append(u); }
            continue;
        }
        for (label k = rowStart_[u]; k < rowStart_[u + 1]; ++k)
        {
            if (constraints_ && !constraints_->isFree(col_[k])) continue;
            entries.append(k);
            r.append(u);
            c.append(col_[k]);
        }
    }
    for (label& u : r) u = rows_.global(u);
    for (label& u : c) u = cols_.global(u);
    entry_.transfer(entries);
    row.transfer(r);
    col.transfer(c);
}


void Foam::feMatrix::values(scalarField& v) const
{
    v.setSize(entry_.size());
    const label n = entry_.size();
    #pragma omp parallel for schedule(static)
    for (label i = 0; i < n; ++i) v[i] = entry_[i] < 0 ? 1.0 : values_[entry_[i]];
}


// ************************************************************************* //
