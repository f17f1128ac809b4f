/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "CGALRemesher.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/SMDS_3/tet_soup_to_c3t3.h>
#include <CGAL/Tetrahedral_remeshing/Remeshing_triangulation_3.h>
#include <CGAL/tetrahedral_remeshing.h>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace remeshers
{
namespace
{

typedef ::CGAL::Exact_predicates_inexact_constructions_kernel kernel;
typedef ::CGAL::Tetrahedral_remeshing::Remeshing_triangulation_3<kernel> triangulation;


bool build(const simplexMesh& old, triangulation& tets)
{
    std::vector<kernel::Point_3> points;
    for (const point& p : old.points) points.emplace_back(p.x(), p.y(), p.z());

    // Domain 0 is the outside
    std::vector<std::array<int, 4>> cells;
    std::vector<int> domains;
    forAll(old.cells, c)
    {
        const labelList& v = old.cells[c];
        cells.push_back({v[0], v[1], v[2], v[3]});
        domains.push_back(old.domains[c] + 1);
    }
    const boost::unordered_map<std::array<int, 3>, triangulation::Cell::Surface_patch_index> noPatches;
    return ::CGAL::SMDS_3::build_triangulation_with_subdomains_range
    (
        tets, points, cells, domains, noPatches, false, false, false
    );
}


//- Smallest angle between two faces of a tetrahedron, degrees
scalar minAngle(const triangulation& tets)
{
    scalar least = 180;
    for (const auto cell : tets.finite_cell_handles())
    {
        if (cell->subdomain_index() < 1) continue;
        least = min(least, scalar(::CGAL::Tetrahedral_remeshing::min_dihedral_angle(tets, cell)));
    }
    return least;
}


void extract(const triangulation& tets, const simplexMesh& old, simplexMesh& now)
{
    typedef std::array<double, 3> place;
    const auto at = [](const auto& p) { return place({p.x(), p.y(), p.z()}); };
    std::map<place, label> origin;
    forAll(old.points, i) origin[at(old.points[i])] = i;

    std::map<triangulation::Vertex_handle, label> number;
    DynamicList<point> points;
    DynamicList<label> origins, domains;
    DynamicList<labelList> cells;
    for (const auto cell : tets.finite_cell_handles())
    {
        if (cell->subdomain_index() < 1) continue;
        labelList v(4);
        forAll(v, i)
        {
            const auto found = number.emplace(cell->vertex(i), points.size());
            v[i] = found.first->second;
            if (!found.second) continue;
            const place p(at(cell->vertex(i)->point()));
            const auto same = origin.find(p);
            points.append(point(p[0], p[1], p[2]));
            origins.append(same == origin.end() ? -1 : same->second);
        }
        cells.append(v);
        domains.append(cell->subdomain_index() - 1);
    }
    now.points.transfer(points);
    now.origin.transfer(origins);
    now.cells.transfer(cells);
    now.domains.transfer(domains);
}

} // End anonymous namespace
} // End namespace remeshers
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::remeshers::remeshTets
(
    const simplexMesh& old,
    const remesher::sizeField& size,
    const label nIterations,
    simplexMesh& now
)
{
    triangulation tets;
    if (!build(old, tets))
    {
        return "the boundary of the selected cells meets itself at an edge or a point";
    }
    // With this the cells have the mean volume of regular ones with the edges that are
    // asked for: measured, exchanging uniform meshes again and again
    const scalar calibration = 1.03;
    const auto length = [&](const kernel::Point_3& p, const int, const triangulation::Vertex::Index&) -> double
    {
        return calibration*size(point(p.x(), p.y(), p.z()));
    };

    // More iterations where slivers are left, the best of which counts. A call smooths
    // thrice at its end, so that one with several iterations takes half the time
    const scalar enough = 10;
    scalar best = -1;
    for (label i = nIterations; i <= 3*nIterations && best < enough; ++i)
    {
        ::CGAL::tetrahedral_isotropic_remeshing
        (
            tets, length,
            ::CGAL::parameters::remesh_boundaries(false).number_of_iterations(i == nIterations ? nIterations : 1)
        );
        const scalar angle = minAngle(tets);
        if (angle <= best) continue;
        best = angle;
        extract(tets, old, now);
    }
    return "";
}


// ************************************************************************* //
