/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pinchedPoints.H"
#include "FixedList.H"
#include "HashSet.H"
#include "labelPair.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Sides opposite to a point are one closed chain
static bool isFan(DynamicList<labelPair> sides)
{
    const label first = sides.last().first();
    label end = sides.last().second();
    sides.remove();
    while (end != first)
    {
        label next = -1;
        forAll(sides, i)
        {
            if (sides[i].first() != end && sides[i].second() != end) continue;
            if (next >= 0) return false;
            next = i;
        }
        if (next < 0) return false;
        end = sides[next].first() == end ? sides[next].second() : sides[next].first();
        sides[next] = sides.last();
        sides.remove();
    }
    return sides.empty();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::pinchedPoints(const simplexMesh& mesh)
{
    // Faces of one cell only
    typedef FixedList<label, 3> side;
    HashSet<side, side::Hash<>> boundary;
    for (const labelList& cell : mesh.cells) for (label i = 0; i < 4; ++i)
    {
        side s{cell[(i + 1)%4], cell[(i + 2)%4], cell[(i + 3)%4]};
        std::sort(s.begin(), s.end());
        if (!boundary.insert(s)) boundary.erase(s);
    }
    List<DynamicList<labelPair>> opposite(mesh.points.size());
    for (const side& s : boundary)
    {
        for (label i = 0; i < 3; ++i) opposite[s[i]].append(labelPair(s[(i + 1)%3], s[(i + 2)%3]));
    }
    DynamicList<label> points;
    forAll(opposite, p) if (opposite[p].size() && !isFan(opposite[p])) points.append(p);
    return labelList(points);
}


// ************************************************************************* //
