/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "simplexField.H"
#include "HashTable.H"
#include "DynamicList.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A place is in a cell
static constexpr scalar outside = -1e-9;

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::simplexField::findNeighbours()
{
    typedef FixedList<label, 3> side;
    HashTable<labelPair, side, side::Hash<>> open;
    neighbours_.setSize(mesh_.cells.size(), four(label(-1)));
    forAll(mesh_.cells, c) forAll(mesh_.cells[c], i)
    {
        side s(label(-1));
        label k = 0;
        forAll(mesh_.cells[c], j) if (j != i) s[k++] = mesh_.cells[c][j];
        std::sort(s.begin(), s.end());
        const auto other = open.find(s);
        if (!other.found())
        {
            open.insert(s, labelPair(c, i));
            continue;
        }
        neighbours_[c][i] = other().first();
        neighbours_[other().first()][other().second()] = c;
        open.erase(other);
    }
}


void Foam::simplexField::makeGrid()
{
    box_ = boundBox(mesh_.points, false);
    n_ = max(label(std::pow(mesh_.cells.size()/4, 1.0/mesh_.dim)), label(1));
    cellOf_.setSize(mesh_.dim == 2 ? n_*n_ : n_*n_*n_, -1);
    forAll(mesh_.cells, c)
    {
        point centre = Zero;
        for (const label p : mesh_.cells[c]) centre += mesh_.points[p]/mesh_.cells[c].size();
        cellOf_[boxOf(centre)] = c;
    }

    // Empty boxes have the cell of the next one, along one axis after the other
    for (label stride = 1; stride < cellOf_.size(); stride *= n_) forAll(cellOf_, i)
    {
        const label back = cellOf_.size() - 1 - i;
        if (i >= stride && (i/stride) % n_ && cellOf_[i] < 0) cellOf_[i] = cellOf_[i - stride];
        if ((back/stride + 1) % n_ && cellOf_[back] < 0) cellOf_[back] = cellOf_[back + stride];
    }
}


Foam::label Foam::simplexField::boxOf(const point& p) const
{
    label box = 0;
    for (direction a = 0; a < mesh_.dim; ++a)
    {
        const scalar part = (p[a] - box_.min()[a])/max(box_.max()[a] - box_.min()[a], VSMALL);
        box = box*n_ + min(max(label(part*n_), label(0)), n_ - 1);
    }
    return box;
}


Foam::label Foam::simplexField::weights(const label cell, const point& p, scalar* w) const
{
    const labelList& v = mesh_.cells[cell];
    const vector a(mesh_.points[v[1]] - mesh_.points[v[0]]), b(mesh_.points[v[2]] - mesh_.points[v[0]]);
    const vector r(p - mesh_.points[v[0]]);
    if (mesh_.dim == 2)
    {
        const scalar size = a.x()*b.y() - a.y()*b.x();
        w[1] = (r.x()*b.y() - r.y()*b.x())/size;
        w[2] = (a.x()*r.y() - a.y()*r.x())/size;
        w[0] = 1 - w[1] - w[2];
    }
    else
    {
        const vector c(mesh_.points[v[3]] - mesh_.points[v[0]]), bc(b ^ c);
        const scalar size = a & bc;
        w[1] = (r & bc)/size;
        w[2] = (r & (c ^ a))/size;
        w[3] = (r & (a ^ b))/size;
        w[0] = 1 - w[1] - w[2] - w[3];
    }
    label least = 0;
    for (label i = 1; i <= mesh_.dim; ++i) if (w[i] < w[least]) least = i;
    return least;
}


Foam::label Foam::simplexField::walk(const point& p, label cell, scalar* w) const
{
    for (label step = 0; step < mesh_.cells.size(); ++step)
    {
        const label least = weights(cell, p, w);
        if (w[least] >= outside) return cell;
        const label next = neighbours_[cell][least];
        if (next < 0) break;
        cell = next;
    }
    return lookAround(p, cell, w);
}


Foam::label Foam::simplexField::lookAround(const point& p, const label first, scalar* w) const
{
    ++search_;
    DynamicList<label> front;
    front.append(first);
    seen_[first] = search_;
    label best = first;
    scalar excess = -GREAT;
    for (label i = 0; i < front.size(); ++i)
    {
        const scalar least = w[weights(front[i], p, w)];
        if (least > excess)
        {
            best = front[i];
            excess = least;
        }
        if (excess >= outside) break;
        for (label k = 0; k <= mesh_.dim; ++k)
        {
            const label next = neighbours_[front[i]][k];
            if (next < 0 || seen_[next] == search_) continue;
            seen_[next] = search_;
            front.append(next);
        }
    }
    weights(best, p, w);
    return best;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::simplexField::simplexField(const simplexMesh& mesh, const scalarField& values)
:
    mesh_(mesh),
    values_(values),
    seen_(mesh.cells.size(), 0),
    search_(0)
{
    findNeighbours();
    makeGrid();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::simplexField::operator()(const point& p) const
{
    scalar w[4], value = 0, sum = 0;
    const labelList& cell = mesh_.cells[walk(p, cellOf_[boxOf(p)], w)];
    forAll(cell, i)
    {
        const scalar part = max(w[i], scalar(0));
        value += part*values_[cell[i]];
        sum += part;
    }
    return value/sum;
}


// ************************************************************************* //
