/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseChecks.H"
#include "elementQuality.H"
#include "fourDigits.H"
#include "readNumber.H"
#include "IOdictionary.H"
#include "pointFields.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Of a region's materials: least and largest density, kg/m3, and speed of
//  waves sqrt(E/rho) or sqrt(B/rho), m/s (0: not known)
struct materialRange
{
    scalar minRho = GREAT, maxRho = 0, speed = 0;

    void add(const scalar rho, const scalar modulus)
    {
        minRho = min(minRho, rho);
        maxRho = max(maxRho, rho);
        if (rho > 0) speed = max(speed, ::sqrt(modulus/rho));
    }
};


static scalar optional(const dictionary& dict, const word& keyword, const dimensionSet& dimensions)
{
    return dict.found(keyword) ? readNumber(dict, keyword, dimensions, -GREAT, GREAT) : 0;
}


static IOdictionary constantDict(const word& name, const fvMesh& mesh)
{
    return IOdictionary
    (
        IOobject
        (
            name, mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
}


//- A warning where a number is that of no material in SI units
static void checkRange
(
    const dictionary& dict, const word& keyword, const scalar value, const scalar low, const scalar high
)
{
    if (value == 0 || (value >= low && value <= high)) return;
    IOWarningInFunction(dict)
        << keyword << " is " << fourDigits(value) << ", expected " << low << " to " << high
        << " in SI units: is it in others?" << endl;
}


static materialRange materialsOf(const feRegion& region)
{
    materialRange range;
    const auto add = [&](const dictionary& dict, const word& stiffness)
    {
        const scalar rho = optional(dict, "rho", dimDensity), modulus = optional(dict, stiffness, dimPressure);
        checkRange(dict, "rho", rho, 1e-3, 3e4);
        checkRange(dict, stiffness, modulus, 1e-3, 1e13);
        range.add(rho, modulus);
    };
    const IOdictionary fluid(constantDict("transportProperties", region.mesh()));
    const IOdictionary solid(constantDict("mechanicalProperties", region.mesh()));
    if (!region.leads()) add(fluid, "bulkModulus");
    else if (solid.found("materials"))
    {
        for (const entry& e : PtrList<entry>(solid.lookup("materials"))) add(e.dict(), "E");
    }
    return range;
}


//- The shapes of a region's elements as they are; a warning where one is bad.
//  Returns the smallest size, m
static scalar checkElements(const feRegion& region)
{
    const feMesh& fe = region.fe();
    const elementQualities all(qualities(fe, fe.points() + region.motion().D));
    scalar worst = GREAT, size = GREAT, aspect = 0;
    label cell = -1;
    forAll(all, b) forAll(all[b], e)
    {
        const elementQuality& q = all[b][e];
        size = min(size, q.volume > 0 ? ::pow(q.volume, 1.0/fe.dim()) : 0);
        aspect = max(aspect, q.aspectRatio);
        if (q.scaledJacobian >= worst) continue;
        worst = q.scaledJacobian;
        cell = fe.blocks()[b].cells[e];
    }
    const scalar least = returnReduce(worst, minOp<scalar>());
    reduce(aspect, maxOp<scalar>());
    reduce(size, minOp<scalar>());
    Info<< "Elements of " << region.name() << ": smallest " << fourDigits(size)
        << " m, least scaled Jacobian " << fourDigits(least) << ", largest aspect ratio " << fourDigits(aspect);
    if (worst == least && least < 0.05)
    {
        WarningInFunction
            << "Region " << region.name() << ": the element of cell " << cell << " at "
            << region.mesh().cellCentres()[cell] << (least <= 0 ? " is inverted" : " is nearly inverted")
            << " (scaled Jacobian " << fourDigits(least) << ") before the first step. Mend the mesh there"
            << " (feCheckMesh lists its worst elements)" << endl;
    }
    return size;
}


//- A warning of points of patches that slide where faces are at more than 60
//  degrees: at an edge or a corner the mean of their normals is that of neither
static void checkSlidingEdges(const pointVectorField& field)
{
    const fvMesh& mesh = refCast<const fvMesh>(field.mesh().thisDb());
    forAll(field.boundaryField(), patchi)
    {
        const word type(field.boundaryField()[patchi].type());
        if (type != "slip" && type != "symmetry") continue;
        const polyPatch& pp = mesh.boundaryMesh()[patchi];
        label n = 0;
        point at = point::min;
        forAll(pp.pointFaces(), p)
        {
            bool edge = false;
            for (const label f : pp.pointFaces()[p]) for (const label g : pp.pointFaces()[p])
            {
                edge = edge || (pp.faceNormals()[f] & pp.faceNormals()[g]) < 0.5;
            }
            if (edge && ++n == 1) at = pp.localPoints()[p];
        }
        reduce(at, maxOp<point>());
        if (!returnReduce(n, sumOp<label>())) continue;
        WarningInFunction
            << "Region " << mesh.name() << ", field " << field.name() << ": patch " << pp.name() << " of type "
            << type << " has an edge or a corner inside, as at " << at << ". What slides there takes the mean"
            << " of the faces' normals and leaves them. Give each side of it a patch of its own" << endl;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void checkCase(const coupledSystem& problem, const scalar deltaT)
{
    List<materialRange> materials(problem.regions().size());
    forAll(materials, r)
    {
        const feRegion& region = problem.regions()[r];
        materials[r] = materialsOf(region);
        const scalar size = checkElements(region);
        const auto fields(region.mesh().lookupClass<pointVectorField>());
        for (const word& name : fields.sortedToc()) checkSlidingEdges(*fields[name]);
        if (materials[r].speed > 0 && size > 0 && !region.timeScheme().steady())
        {
            Info<< "; its waves pass " << fourDigits(deltaT*materials[r].speed/size)
                << " of the smallest elements in deltaT";
        }
        Info<< nl;
    }
    for (const feInterface& i : problem.interfaces())
    {
        if (!i.moves()) continue;
        scalar fluid = 0, solid = 0;
        forAll(materials, r)
        {
            if (&problem.regions()[r] == &i.follower()) fluid = materials[r].maxRho;
            if (&problem.regions()[r] == &i.leader()) solid = materials[r].maxRho;
        }
        if (!(fluid > 0 && solid > 0) || (solid < 1e5*fluid && fluid < 1e5*solid)) continue;
        WarningInFunction
            << "Interface " << i.name() << ": the densities of fluid and solid are " << fourDigits(fluid) << " and "
            << fourDigits(solid) << " kg/m3: are both in SI units?" << endl;
    }
    Info<< nl;
}

} // End namespace Foam

// ************************************************************************* //
