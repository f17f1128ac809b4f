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

void Foam::elementScatter::gather
(
    const elementBlock& block,
    const fieldUnknowns& unknowns,
    label& n,
    labelList& nodes,
    List<part>& parts
)
{
    const fieldLayout& layout = unknowns.layout();
    n = block.nNodes + (layout.hasCells() ? 1 : 0);
    nodes.setSize(block.size()*n);
    const auto entity = [&](const label e, const label i)
    {
        return i < block.nNodes ? block.element(e)[i] : layout.fe().nNodes() + block.cells[e];
    };
    for (label e = 0; e < block.size(); ++e)
    {
        for (label i = 0; i < n; ++i) nodes[e*n + i] = unknowns.node(entity(e, i));
    }

    parts.setSize(layout.nFields());
    forAll(parts, f)
    {
        part& p = parts[f];
        const fieldLayout::support on = layout[f].on;
        p.nCmpts = layout.nComponents(f);
        p.first = on == fieldLayout::support::CELLS ? block.nNodes : 0;
        p.n =
            on == fieldLayout::support::BODIES ? 0
          : on == fieldLayout::support::CELLS ? 1
          : on == fieldLayout::support::NODES ? block.nNodes : block.nVertices();
        p.offset.setSize(block.size()*n, 0);
        for (label e = 0; e < block.size(); ++e) for (label i = p.first; i < p.first + p.n; ++i)
        {
            const label start = unknowns.start(f, layout.value(f, entity(e, i)));
            p.offset[e*n + i] = start - unknowns.map().start(nodes[e*n + i]);
        }
    }
}


Foam::elementScatter::elementScatter
(
    const elementBlock& block,
    const fieldUnknowns& rowUnknowns,
    const fieldUnknowns& colUnknowns
)
:
    tied(block.size(), false)
{
    gather(block, rowUnknowns, nRow, rowNodes, rows);
    gather(block, colUnknowns, nCol, colNodes, cols);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::feMatrix::addToGraph
(
    const elementScatter& block,
    List<DynamicList<label>>& graph
) const
{
    List<labelList> masters;
    if (constraints_) masters = constrainedNodes(block);
    for (label e = 0; e < block.nElements(); ++e)
    {
        const label* I = &block.rowNodes[e*block.nRow];
        const label* J = &block.colNodes[e*block.nCol];
        for (label i = 0; i < block.nRow; ++i)
        {
            for (label j = 0; j < block.nCol; ++j) graph[I[i]].append(J[j]);
        }
        if (masters.empty() || masters[e].empty()) continue;

        // Nodes of the masters join those of the element
        for (const label m : masters[e])
        {
            for (label i = 0; i < block.nRow; ++i)
            {
                graph[I[i]].append(m);
                graph[m].append(J[i]);
            }
            graph[m].append(masters[e]);
        }
    }
}


Foam::List<Foam::labelList> Foam::feMatrix::constrainedNodes
(
    const elementScatter& block
) const
{
    List<labelList> masters(block.nElements());
    for (label e = 0; e < block.nElements(); ++e)
    {
        if (!block.tied[e]) continue;
        const SubList<label> own(block.rowNodes, block.nRow, e*block.nRow);
        labelHashSet all;
        for (const label I : own) for (label u = rows_.start(I); u < rows_.start(I + 1); ++u)
        {
            if (!constraints_->isTied(u)) continue;
            for (const auto& t : constraints_->masters(u)) all.insert(rowNodeOf_[t.unknown]);
        }
        for (const label I : own) all.erase(I);
        masters[e] = all.sortedToc();
    }
    return masters;
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
    if (found == end || *found != colNode)
    {
        FatalErrorInFunction
            << "Nodes " << rowNode << " and " << colNode << " have no element in"
            << " common, nor a constraint that joins them: no place in the matrix"
            << abort(FatalError);
    }
    return nodeOffset_[nodeStart_[rowNode] + (found - begin)];
}


void Foam::feMatrix::addEntry
(
    const label row,
    const label col,
    const scalar value
)
{
    const label I = rowNodeOf_[row], J = colNodeOf_[col];
    values_[rowStart_[row] + position(I, J) + col - cols_.start(J)] += value;
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
        if (!c.isTied(col) || affine_) addEntry(r, col, v);
        if (c.isTied(col)) for (const auto& t : c.masters(col)) addEntry(r, t.unknown, t.weight*v);
    };
    if (!c.isTied(row)) addRow(row, value);
    else for (const auto& t : c.masters(row)) addRow(t.unknown, t.transposed*value);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feMatrix::feMatrix
(
    const nodeMap& rows,
    const nodeMap& cols,
    const dofConstraints* constraints,
    const UPtrList<elementScatter>& blocks,
    const bool affine
)
:
    rows_(rows),
    cols_(cols),
    constraints_(constraints),
    affine_(affine),
    nodeStart_(rows.nNodes() + 1, 0),
    rowStart_(rows.nUnknowns() + 1, 0),
    rowNodeOf_(rows.nUnknowns()),
    colNodeOf_(cols.nUnknowns())
{
    const auto fill = [](const nodeMap& map, labelList& nodeOf)
    {
        for (label I = 0; I < map.nNodes(); ++I)
        {
            for (label u = map.start(I); u < map.start(I + 1); ++u) nodeOf[u] = I;
        }
    };
    fill(rows, rowNodeOf_);
    fill(cols, colNodeOf_);

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
                    if (constraints_->isTied(u)) block.tied[k/block.nRow] = true;
                }
            }
        }
        addToGraph(block, graph);
    }

    forAll(graph, I)
    {
        // A node without elements, as that of a rigid body, has its own place
        if (graph[I].empty() && &rows == &cols) graph[I].append(I);
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
        const label nR = block.nRow, nC = block.nCol;
        block.position.setSize(block.nElements()*nR*nC);
        for (label e = 0; e < block.nElements(); ++e)
        {
            for (label i = 0; i < nR; ++i) for (label j = 0; j < nC; ++j)
            {
                block.position[(e*nR + i)*nC + j] =
                    position(block.rowNodes[e*nR + i], block.colNodes[e*nC + j]);
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
    const label rowField, const label colField,
    const scalar scale
)
{
    const int nLanes = block.nLanes(batch);
    const label nR = scatter.nRow, nC = scatter.nCol;
    const elementScatter::part& rows = scatter.rows[rowField];
    const elementScatter::part& cols = scatter.cols[colField];

    // Lanes with tied unknowns go entry by entry
    label element[packSize];
    const label *position[packSize], *rowNode[packSize], *rowOffset[packSize], *colOffset[packSize];
    int lane[packSize], tiedLane[packSize], nFree = 0, nTied = 0;
    for (int l = 0; l < nLanes; ++l)
    {
        const label e = element[l] = block.lane(batch, l);
        if (scatter.tied[e])
        {
            tiedLane[nTied++] = l;
            continue;
        }
        lane[nFree] = l;
        position[nFree] = &scatter.position[(e*nR + rows.first)*nC + cols.first];
        rowNode[nFree] = &scatter.rowNodes[e*nR + rows.first];
        rowOffset[nFree] = &rows.offset[e*nR + rows.first];
        colOffset[nFree++] = &cols.offset[e*nC + cols.first];
    }

    // The loops over components have sizes known to the compiler
    const auto addAs = [&](const auto nRows, const auto nCols)
    {
        constexpr int R = nRows(), C = nCols();
        alignas(64) double entries[R*C*packSize];
        const pack* Kij = K;
        for (label i = 0; i < rows.n; ++i)
        {
            scalar* row[packSize];
            label length[packSize];
            for (int f = 0; f < nFree; ++f)
            {
                const label u = rows_.start(rowNode[f][i]) + rowOffset[f][i];
                length[f] = rowStart_[u + 1] - rowStart_[u];
                row[f] = values_.begin() + rowStart_[u];
            }
            for (label j = 0; j < cols.n; ++j, Kij += R*C)
            {
                for (int k = 0; k < R*C; ++k)
                {
                    (scale*Kij[k]).copy_to(entries + k*packSize, stdx::vector_aligned);
                }
                for (int f = 0; f < nFree; ++f)
                {
                    scalar* to = row[f] + position[f][i*nC + j] + colOffset[f][j];
                    const double* from = entries + lane[f];
                    for (int a = 0; a < R; ++a) for (int b = 0; b < C; ++b)
                    {
                        to[a*length[f] + b] += from[(a*C + b)*packSize];
                    }
                }
                for (int t = 0; t < nTied; ++t)
                {
                    const label I = element[tiedLane[t]]*nR + rows.first + i;
                    const label J = element[tiedLane[t]]*nC + cols.first + j;
                    const label u = rows_.start(scatter.rowNodes[I]) + rows.offset[I];
                    const label v = cols_.start(scatter.colNodes[J]) + cols.offset[J];
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
    switch (10*rows.nCmpts + cols.nCmpts)
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
                << "Blocks of " << rows.nCmpts << " x " << cols.nCmpts << " components"
                << abort(FatalError);
    }
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
            if (rows_.owned(rowNodeOf_[u])) { entries.append(-1); r.append(u); c.append(u); }
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
