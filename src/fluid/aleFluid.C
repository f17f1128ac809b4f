/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(aleFluid, 0);
    addToRunTimeSelectionTable(feRegion, aleFluid, mesh);
}

const Foam::Enum<Foam::aleFluid::elementFamily>
Foam::aleFluid::elementFamilyNames
({
    {elementFamily::EQUAL_ORDER, "equalOrder"},
    {elementFamily::TAYLOR_HOOD, "taylorHood"},
});

const Foam::Enum<Foam::aleFluid::stabilisationType>
Foam::aleFluid::stabilisationNames
({
    {stabilisationType::NONE, "none"},
    {stabilisationType::METRIC, "metric"},
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aleFluid::readTransport()
{
    const dimensionedScalar rho("rho", dimDensity, transport_);
    k_.rho = rho.value();
    if (transport_.found("mu"))
    {
        k_.mu = dimensionedScalar("mu", dimDynamicViscosity, transport_).value();
        // Stock function objects (forces) look for nu
        transport_.set("nu", dimensionedScalar("nu", dimViscosity, k_.mu/k_.rho));
    }
    else
    {
        k_.mu = k_.rho*dimensionedScalar("nu", dimViscosity, transport_).value();
    }
    if (transport_.found("bulkModulus"))
    {
        const dimensionedScalar B("bulkModulus", dimPressure, transport_);
        k_.rBulk = 1/B.value();
    }
    if (k_.rho <= 0 || k_.mu < 0 || k_.rBulk < 0 || !std::isfinite(k_.rho + k_.mu + k_.rBulk))
    {
        FatalIOErrorInFunction(transport_)
            << "Found rho " << k_.rho << ", mu " << k_.mu << ", 1/bulkModulus "
            << k_.rBulk << "; expected a positive density and bulk modulus and"
            << " a viscosity that is not negative" << exit(FatalIOError);
    }

    IOdictionary turbulence
    (
        IOobject
        (
            "turbulenceProperties", mesh_.time().constant(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    const word type(turbulence.lookupOrDefault<word>("simulationType", "laminar"));
    if (type != "laminar")
    {
        FatalIOErrorInFunction(turbulence)
            << "Unknown simulationType " << type << ". Valid: (laminar)"
            << exit(FatalIOError);
    }

    k_.equalOrder = family_ == elementFamily::EQUAL_ORDER;
    const stabilisationType stabilisation = stabilisationNames.lookupOrDefault
    (
        "stabilisation", schemes_,
        k_.equalOrder ? stabilisationType::METRIC : stabilisationType::NONE
    );
    k_.stabilised = stabilisation == stabilisationType::METRIC;
    if (k_.equalOrder && !k_.stabilised)
    {
        FatalIOErrorInFunction(schemes_)
            << "Elements equalOrder with stabilisation none have a singular"
            << " pressure. Choose stabilisation metric, or elements taylorHood"
            << exit(FatalIOError);
    }
    if (!k_.equalOrder) k_.pspg = 0;
}


void Foam::aleFluid::readPressureReference()
{
    pRefNode_ = -1;
    pRefValue_ = schemes_.lookupOrDefault<scalar>("pRefValue", 0);
    if (!schemes_.found("pRefPoint")) return;

    for (const pointPatchVectorField& patch : pointU_().boundaryField())
    {
        if (patch.type() != "openBoundary") continue;
        FatalIOErrorInFunction(schemes_)
            << "Found pRefPoint, but patch " << patch.patch().name()
            << " lets the fluid out (openBoundary), which gives the pressure"
            << " its level. Remove pRefPoint" << exit(FatalIOError);
    }

    const pointField& points = fe().points();
    scalar distance;
    const auto findNearest = [&](const point& x)
    {
        distance = GREAT;
        for (label n = 0; n < fe().nVertices(); ++n)
        {
            if (mag(points[n] - x) >= distance) continue;
            distance = mag(points[n] - x);
            pRefNode_ = n;
        }
    };

    // The vertex of the first rank that has a nearest one, and its copies
    findNearest(schemes_.get<point>("pRefPoint"));
    label owner = distance > returnReduce(distance, minOp<scalar>()) ? labelMax : Pstream::myProcNo();
    reduce(owner, minOp<label>());
    point at = owner == Pstream::myProcNo() ? points[pRefNode_] : point::max;
    reduce(at, minOp<point>());
    findNearest(at);
    if (distance > 1e-9*mesh_.bounds().mag()) pRefNode_ = -1;
}


void Foam::aleFluid::readMotion()
{
    IOdictionary dict
    (
        IOobject
        (
            "dynamicMeshDict", mesh_.time().constant(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    );
    if (dict.empty()) return;

    const word solver(dict.get<word>("motionSolver"));
    if (solver != "feLaplacian")
    {
        FatalIOErrorInFunction(dict)
            << "Unknown motionSolver " << solver << " for aleFluid."
            << " Valid: (feLaplacian)" << exit(FatalIOError);
    }
    motionDict_ = dict.subOrEmptyDict("feLaplacianCoeffs");
    motionDict_.set("motionSolver", solver);

    IOobject io
    (
        "pointDisplacement", mesh_.time().timeName(), mesh_,
        IOobject::MUST_READ, IOobject::AUTO_WRITE
    );
    if (io.typeHeaderOk<pointVectorField>())
    {
        pointDisplacement_ = readPointField<vector>("pointDisplacement", mesh_, dimLength);
    }
}


void Foam::aleFluid::makeMotion(const labelUList& patches)
{
    IOdictionary solution
    (
        IOobject
        (
            "feSolution", mesh_.time().system(), mesh_.time(),
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    motion_.reset
    (
        new laplaceMotion
        (
            fe(), pointDisplacement_.get(), patches, motionDict_,
            solution.subDict("linearSolver")
        )
    );
}


void Foam::aleFluid::initialise()
{
    v_.v = fe().interpolate<vector>(pointU_->primitiveField());
    q_.v = fe().interpolate<scalar>(pointP_->primitiveField());
    if (pointDisplacement_.valid())
    {
        mesh_D_.D = fe().interpolate<vector>(pointDisplacement_->primitiveField());
    }
    state_.add("U", v_);
    state_.add("p", q_);
    state_.add("meshDisplacement", mesh_D_);
    state_.store();

    faceArea_ = Foam::pow(fe().meanSize(), fe().dim() - 1);
}


Foam::scalar Foam::aleFluid::stageTime() const
{
    const feTimeScheme& ts = timeScheme();
    return mesh_.time().value() - (1 - ts.stage())*ts.deltaT();
}


bool Foam::aleFluid::pressureNode(const label node) const
{
    return k_.equalOrder || node < fe().nVertices();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aleFluid::aleFluid(fvMesh& mesh)
:
    feRegion
    (
        mesh,
        elementFamilyNames.get("elements", readSchemes(mesh)) == elementFamily::TAYLOR_HOOD ? 2 : 1
    ),
    family_(elementFamilyNames.get("elements", schemes_)),
    assembly_(fe()),
    transport_(dictObject("transportProperties", mesh.time().constant(), mesh)),
    pointU_(readPointField<vector>("pointU", mesh, dimVelocity)),
    pointP_(readPointField<scalar>("pointP", mesh, dimPressure)),
    U_
    (
        IOobject("U", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
        mesh, dimensionedVector(dimVelocity, Zero)
    ),
    p_
    (
        IOobject("p", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE),
        mesh, dimensionedScalar(dimPressure, Zero)
    ),
    v_(fe().nNodes()),
    q_(fe().nNodes()),
    mesh_D_(fe().nNodes()),
    stage_(fe().nNodes()),
    meshAcceleration_(fe().nNodes()),
    continuity_(fe().nNodes())
{
    k_.g = g_.value();
    readTransport();
    readPressureReference();
    readMotion();
    initialise();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::aleFluid::nUnknowns(const label node) const
{
    return fe().dim() + (pressureNode(node) ? 1 : 0);
}


Foam::word Foam::aleFluid::unknownName(const label c) const
{
    return c == fe().dim() ? word("pointP") : word("pointU." + Foam::name(c));
}


void Foam::aleFluid::setInterface(const labelUList& patches)
{
    if (!moving())
    {
        FatalErrorInFunction
            << "Region " << name() << " shares an interface with a solid, but"
            << " its mesh cannot move." << nl
            << "Give " << mesh_.time().constant()/name()/"dynamicMeshDict"
            << " with motionSolver feLaplacian;" << exit(FatalError);
    }
    labelHashSet nodes;
    for (const label patchi : patches) nodes.insert(fe().patchNodes(patchi));
    interface_ = nodes.sortedToc();
    makeMotion(patches);
}


void Foam::aleFluid::connect
(
    const labelUList& systemNode,
    const nodeMap& map
)
{
    feRegion::connect(systemNode, map);
    if (!motion_.valid())
    {
        // The boundary moves as told, and its motion has no tangent
        if (pointDisplacement_.valid()) makeMotion(labelList());
        return;
    }

    const labelList node(identity(fe().nNodes()));
    shapeColumns_.reset(new nodeMap(fe().key(), labelList(fe().nNodes(), fe().dim())));
    shapeScatter_.clear();
    for (const elementBlock& block : fe().blocks())
    {
        shapeScatter_.append(new elementScatter(block, systemNode, node));
    }
    S_.reset(new feMatrix(map, shapeColumns_(), nullptr, shapeScatter_));
    shapeD_.setSize(fe().nNodes());
    shapeX_.setSize(shapeColumns_->nUnknowns());
    shapeY_.setSize(map.nUnknowns());
}


void Foam::aleFluid::constrain(dofConstraints& c) const
{
    const nodalBoundary boundary(fe());
    boundary.constrain(pointU_(), systemNode_, *map_, c);
    boundary.constrain(pointP_(), systemNode_, *map_, fe().dim(), c);
    if (pRefNode_ != -1) c.fix(map_->start(systemNode_[pRefNode_]) + fe().dim());
}


void Foam::aleFluid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    v_.predict(ts);
    q_.predict(ts);
    mesh_D_.predict(ts);

    const nodalBoundary boundary(fe());
    boundary.forValues
    (
        pointU_(), time, systemNode_, *map_,
        [&](const label n, const vector& u) { v_.set(ts, n, u); }
    );
    boundary.forValues
    (
        pointP_(), time, systemNode_, *map_,
        [&](const label n, const scalar p) { q_.set(ts, n, p); }
    );
    if (pRefNode_ != -1) q_.set(ts, pRefNode_, pRefValue_);
    if (pointDisplacement_.valid())
    {
        boundary.forValues
        (
            pointDisplacement_(), time, systemNode_, *map_,
            [&](const label n, const vector& d) { mesh_D_.setD(ts, n, d); }
        );
        if (!hasMotionTangent()) moveMesh();
    }
}


void Foam::aleFluid::update(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    forAll(v_.v, n)
    {
        const label start = map_->start(systemNode_[n]);
        vector dv = Zero;
        for (label a = 0; a < fe().dim(); ++a) dv[fe().axis(a)] = dx[start + a];
        v_.set(ts, n, v_.v[n] + dv);
        if (pressureNode(n)) q_.set(ts, n, q_.v[n] + dx[start + fe().dim()]);
    }
}


void Foam::aleFluid::interfaceMoved()
{
    const feTimeScheme& ts = timeScheme();
    for (const label n : interface_)
    {
        v_.v[n] = ts.steady() ? vector::zero : mesh_D_.v[n];
        v_.a[n] = ts.steady() ? vector::zero : mesh_D_.a[n];
    }
    moveMesh();
}


void Foam::aleFluid::moveMesh()
{
    if (!motion_.valid()) return;
    const feTimeScheme& ts = timeScheme();
    vectorField D(mesh_D_.D);
    motion_->extend(D);
    forAll(D, n) if (!motion_->given(n)) mesh_D_.setD(ts, n, D[n]);
}


Foam::scalar Foam::aleFluid::fluxScale() const
{
    scalar sum = 0;
    forAll(v_.v, n) if (map_->owned(systemNode_[n])) sum += magSqr(v_.v[n]);
    return faceArea_*::sqrt(returnReduce(sum, sumOp<scalar>()));
}


Foam::scalar Foam::aleFluid::velocityScale() const
{
    scalar size = 0;
    forAll(v_.v, n) size = max(size, max(mag(v_.v[n]), mag(mesh_D_.v[n])));
    return returnReduce(size, maxOp<scalar>());
}


void Foam::aleFluid::advance()
{
    if (moving()) mesh_.movePoints(fe().movedPoints(mesh_D_.D));
}


void Foam::aleFluid::derive()
{
    fe().toPoints<vector>(v_.v, pointU_->primitiveFieldRef());

    // Mid-side nodes carry no pressure of Taylor-Hood elements
    scalarField p(q_.v);
    if (!k_.equalOrder && fe().order() == 2)
    {
        List<labelList> parent;
        fe().parents(parent);
        for (label n = fe().nVertices(); n < p.size(); ++n)
        {
            p[n] = 0;
            for (const label m : parent[n]) p[n] += p[m]/parent[n].size();
        }
    }
    fe().toPoints<scalar>(p, pointP_->primitiveFieldRef());
    if (pointDisplacement_.valid())
    {
        fe().toPoints<vector>(mesh_D_.D, pointDisplacement_->primitiveFieldRef());
    }
    toCells<vector>(v_.v, U_);
    toCells<scalar>(p, p_);
}


// ************************************************************************* //
