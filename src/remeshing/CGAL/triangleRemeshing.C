/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Remeshing of triangles in a plane: in each pass

    1. edges longer than 4/3 of their size are divided, points that are nearer
       to another than 0.7 of it are removed;
    2. the points move to the centroids of the triangles around them, weighted
       with area/size^4 (equal numbers of points for equal areas in units of
       the size);
    3. a constrained Delaunay triangulation connects them anew.

    Points and edges of the boundary and between domains stay.

    Source: L. Chen, M. Holst, Efficient mesh optimization schemes based on
    optimal Delaunay triangulations, Comput. Methods Appl. Mech. Engrg. 200
    (2011) 967-984: centroidal patch triangulation.
\*---------------------------------------------------------------------------*/

#include "CGALRemesher.H"
#include "labelPair.H"
#include "HashSet.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace Foam
{
namespace remeshers
{
namespace
{

class planeMesh
{
    typedef ::CGAL::Exact_predicates_inexact_constructions_kernel kernel;
    typedef ::CGAL::Triangulation_vertex_base_with_info_2<label, kernel> vertexBase;
    typedef ::CGAL::Triangulation_face_base_with_info_2<label, kernel> faceInfo;
    typedef ::CGAL::Constrained_triangulation_face_base_2<kernel, faceInfo> faceBase;
    typedef ::CGAL::Triangulation_data_structure_2<vertexBase, faceBase> structure;
    typedef ::CGAL::Constrained_Delaunay_triangulation_2
    <
        kernel, structure, ::CGAL::No_constraint_intersection_tag
    > triangulation;
    typedef triangulation::Face_handle faceHandle;
    typedef triangulation::Vertex_handle vertexHandle;

    // Private Data

        const remesher::sizeField& size_;

        //- Fixed ones first
        DynamicList<point> points_;
        label nFixed_;
        labelList fixed_;

        //- Fixed edges, with the domain to the left
        DynamicList<labelPair> edges_;
        DynamicList<label> domains_;

        triangulation mesh_;
        std::vector<vertexHandle> vertex_;

        //- Triangles of the domain
        DynamicList<labelList> cells_;
        DynamicList<label> cellDomains_;


    // Private Member Functions

        bool labelDomains();
        scalar area(const label a, const label b, const label c) const;
        point weightedCentre(const UList<label>& cells) const;


public:

    planeMesh(const simplexMesh& old, const remesher::sizeField& size);

    //- Connect the points; whether the fixed edges are there
    bool triangulate();

    //- Add and remove points
    void adapt();

    //- Move the points
    void smooth();

    void extract(simplexMesh& now) const;
};


planeMesh::planeMesh(const simplexMesh& old, const remesher::sizeField& size)
:
    size_(size)
{
    // Domain to the left of each directed edge
    HashTable<label, labelPair, labelPair::Hash<>> left;
    forAll(old.cells, c) forAll(old.cells[c], i)
    {
        left.set(labelPair(old.cells[c][i], old.cells[c][(i + 1)%3]), old.domains[c]);
    }
    labelList number(old.points.size(), -1);
    DynamicList<label> fixed;
    for (const labelPair& e : left.sortedToc())
    {
        const label domain = left[e];
        if (left.lookup(labelPair(e.second(), e.first()), -1) == domain) continue;
        edges_.append(e);
        domains_.append(domain);
        for (const label p : e)
        {
            if (number[p] >= 0) continue;
            number[p] = fixed.size();
            fixed.append(p);
            points_.append(old.points[p]);
        }
    }
    nFixed_ = fixed.size();
    fixed_.transfer(fixed);
    for (labelPair& e : edges_) e = labelPair(number[e.first()], number[e.second()]);
    forAll(old.points, p) if (number[p] < 0) points_.append(old.points[p]);
}


bool planeMesh::triangulate()
{
    mesh_.clear();
    vertex_.clear();
    faceHandle near;
    forAll(points_, i)
    {
        vertex_.push_back(mesh_.insert({points_[i].x(), points_[i].y()}, near));
        vertex_.back()->info() = i;
        near = vertex_.back()->face();
    }
    if (label(mesh_.number_of_vertices()) != points_.size()) return false;
    for (const labelPair& e : edges_) mesh_.insert_constraint(vertex_[e.first()], vertex_[e.second()]);
    return labelDomains();
}


bool planeMesh::labelDomains()
{
    for (const faceHandle f : mesh_.all_face_handles()) f->info() = -1;
    std::vector<faceHandle> front;
    forAll(edges_, e)
    {
        const vertexHandle a = vertex_[edges_[e].first()], b = vertex_[edges_[e].second()];
        faceHandle f;
        int i;
        if (!mesh_.is_edge(a, b, f, i)) return false;
        if (f->vertex(mesh_.ccw(i)) != a) f = f->neighbor(i);
        f->info() = domains_[e];
        front.push_back(f);
    }
    while (!front.empty())
    {
        const faceHandle f = front.back();
        front.pop_back();
        for (int i = 0; i < 3; ++i)
        {
            const faceHandle g = f->neighbor(i);
            if (f->is_constrained(i) || g->info() == f->info()) continue;
            if (g->info() >= 0) return false;
            g->info() = f->info();
            front.push_back(g);
        }
    }
    cells_.clear();
    cellDomains_.clear();
    for (const faceHandle f : mesh_.all_face_handles())
    {
        if (f->info() < 0) continue;
        if (mesh_.is_infinite(f)) return false;
        cells_.append(labelList({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()}));
        cellDomains_.append(f->info());
    }
    return true;
}


scalar planeMesh::area(const label a, const label b, const label c) const
{
    return 0.5*((points_[b] - points_[a]) ^ (points_[c] - points_[a])).z();
}


void planeMesh::adapt()
{
    // Once for each edge; two triangles share those that are not fixed
    HashSet<labelPair, labelPair::Hash<>> fixed;
    for (const labelPair& e : edges_)
    {
        fixed.insert(labelPair(min(e.first(), e.second()), max(e.first(), e.second())));
    }
    List<bool> moved(points_.size(), false), removed(points_.size(), false);
    DynamicList<point> added;
    for (const labelList& cell : cells_) forAll(cell, i)
    {
        const label a = cell[i], b = cell[(i + 1)%3];
        if (a > b || fixed.found(labelPair(a, b)) || moved[a] || moved[b]) continue;
        const point middle(0.5*(points_[a] + points_[b]));
        const scalar length = mag(points_[b] - points_[a])/size_(middle);
        if (length > 4.0/3) added.append(middle);
        else if (length < 0.7 && b >= nFixed_) removed[b] = true;
        else continue;
        moved[a] = moved[b] = true;
    }
    DynamicList<point> kept;
    forAll(points_, i) if (!removed[i]) kept.append(points_[i]);
    kept.append(added);
    points_.transfer(kept);
}


point planeMesh::weightedCentre(const UList<label>& cells) const
{
    point sum = Zero;
    scalar weight = 0;
    for (const label c : cells)
    {
        const labelList& v = cells_[c];
        const point centre((points_[v[0]] + points_[v[1]] + points_[v[2]])/3);
        const scalar w = area(v[0], v[1], v[2])/pow4(size_(centre));
        sum += w*centre;
        weight += w;
    }
    return sum/weight;
}


void planeMesh::smooth()
{
    List<DynamicList<label>> around(points_.size());
    forAll(cells_, c) for (const label p : cells_[c]) around[p].append(c);

    for (label p = nFixed_; p < points_.size(); ++p)
    {
        const auto worst = [&]()
        {
            scalar least = GREAT;
            for (const label c : around[p])
            {
                const labelList& v = cells_[c];
                scalar l = 0;
                forAll(v, i) l += magSqr(points_[v[(i + 1)%3]] - points_[v[i]]);
                least = min(least, area(v[0], v[1], v[2])/l);
            }
            return least;
        };
        const point before(points_[p]);
        const vector step(weightedCentre(around[p]) - before);
        const scalar enough = min(worst(), 0.05);
        scalar part = 1;
        do
        {
            points_[p] = before + part*step;
            part *= 0.5;
        }
        while (worst() < enough && part > 0.1);
        if (worst() < enough) points_[p] = before;
    }
}


void planeMesh::extract(simplexMesh& now) const
{
    now.points = points_;
    now.origin = labelList(points_.size(), -1);
    forAll(fixed_, i) now.origin[i] = fixed_[i];
    now.cells = cells_;
    now.domains = cellDomains_;
}

} // End anonymous namespace
} // End namespace remeshers
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::remeshers::remeshTriangles
(
    const simplexMesh& old,
    const remesher::sizeField& size,
    const label nIterations,
    simplexMesh& now
)
{
    planeMesh mesh(old, size);
    bool ok = mesh.triangulate();
    for (label pass = 0; ok && pass < 4*nIterations; ++pass)
    {
        // The last ones only smooth
        if (pass < 3*nIterations)
        {
            mesh.adapt();
            ok = mesh.triangulate();
        }
        if (!ok) break;
        mesh.smooth();
        ok = mesh.triangulate();
    }
    if (!ok) return "an edge of the boundary was lost: two of its parts are too near to each other";
    mesh.extract(now);
    return "";
}


// ************************************************************************* //
