/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shapeMesh.H"
#include "cellModel.H"
#include <algorithm>
#include <map>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Cells of a brick with corners v numbered as a hex, centre c
void makeCells
(
    const word& cell,
    const FixedList<label, 8>& v,
    const label c,
    DynamicList<cellShape>& cells
)
{
    const auto add = [&](const cellModel::modelType type, const labelList& nodes)
    {
        cells.append(cellShape(cellModel::ref(type), nodes));
    };
    if (cell == "hex") add(cellModel::HEX, labelList(v));
    else if (cell == "prism")
    {
        add(cellModel::PRISM, {v[0], v[1], v[2], v[4], v[5], v[6]});
        add(cellModel::PRISM, {v[0], v[2], v[3], v[4], v[6], v[7]});
    }
    else if (cell == "tet")
    {
        // Around the diagonal 0 6: the faces of all bricks match
        const label ring[] = {v[1], v[2], v[3], v[7], v[4], v[5]};
        for (label i = 0; i < 6; ++i)
        {
            add(cellModel::TET, {v[0], ring[i], ring[(i + 1)%6], v[6]});
        }
    }
    else
    {
        const label base[6][4] =
            {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
        for (const auto& b : base) add(cellModel::PYR, {v[b[0]], v[b[1]], v[b[2]], v[b[3]], c});
    }
}


//- Faces of one cell only, on the six sides of the unit box
faceListList boundary(const UList<cellShape>& cells, const pointField& points)
{
    std::map<std::vector<label>, label> count;
    const auto key = [](const face& f)
    {
        std::vector<label> points(f.begin(), f.end());
        std::sort(points.begin(), points.end());
        return points;
    };
    for (const cellShape& c : cells) for (const face& f : c.faces()) ++count[key(f)];

    List<DynamicList<face>> sides(6);
    for (const cellShape& c : cells) for (const face& f : c.faces())
    {
        if (count[key(f)] == 2) continue;
        const point x = f.centre(points);
        for (label a = 0; a < 3; ++a)
        {
            if (mag(x[a]) < SMALL) sides[2*a].append(f);
            if (mag(x[a] - 1) < SMALL) sides[2*a + 1].append(f);
        }
    }
    faceListList faces(6);
    forAll(faces, i) faces[i].transfer(sides[i]);
    return faces;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shapeMesh::shapeMesh
(
    const word& cell,
    const FixedList<label, 3>& n,
    const pointMap& map,
    const HashTable<word>& patchTypes
)
{
    DynamicList<point> points;
    for (label k = 0; k <= n[2]; ++k) for (label j = 0; j <= n[1]; ++j) for (label i = 0; i <= n[0]; ++i)
    {
        points.append(point(scalar(i)/n[0], scalar(j)/n[1], scalar(k)/n[2]));
    }
    const auto corner = [&](const label i, const label j, const label k)
    {
        return (k*(n[1] + 1) + j)*(n[0] + 1) + i;
    };

    DynamicList<cellShape> cells;
    for (label k = 0; k < n[2]; ++k) for (label j = 0; j < n[1]; ++j) for (label i = 0; i < n[0]; ++i)
    {
        const FixedList<label, 8> v
        ({
            corner(i, j, k), corner(i + 1, j, k), corner(i + 1, j + 1, k), corner(i, j + 1, k),
            corner(i, j, k + 1), corner(i + 1, j, k + 1), corner(i + 1, j + 1, k + 1), corner(i, j + 1, k + 1)
        });
        if (cell == "pyr") points.append(0.5*(points[v[0]] + points[v[6]]));
        makeCells(cell, v, points.size() - 1, cells);
    }

    const wordList names({"left", "right", "bottom", "top", "back", "front"});
    PtrList<dictionary> dicts(6);
    forAll(names, i)
    {
        dicts.set(i, new dictionary());
        dicts[i].set("type", patchTypes.lookup(names[i], word("patch")));
    }
    pointField unit(points), moved(unit);
    for (point& p : moved) p = map(p);

    dictionary control;
    control.set("startTime", 0);
    control.set("endTime", 1);
    control.set("deltaT", 1);
    control.set("writeFrequency", 1);
    time.reset(new Time(control, "/tmp", "shapeMesh", "system", "constant", false, false));
    mesh.reset
    (
        new polyMesh
        (
            IOobject(polyMesh::defaultRegion, time->constant(), time(), IOobject::NO_READ),
            std::move(moved), cells, boundary(cells, unit), names, dicts,
            "none", "patch"
        )
    );
}


Foam::HashTable<Foam::word> Foam::shapeMesh::twoD()
{
    HashTable<word> types;
    types.set("back", "empty");
    types.set("front", "empty");
    return types;
}


// ************************************************************************* //
