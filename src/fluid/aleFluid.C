/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

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
    // Users' files say Newtonian, which is what there is
    wordList known({"rho", "mu", "nu", "bulkModulus"});
    if (transport_.lookupOrDefault<word>("transportModel", "") == "Newtonian") known.append("transportModel");
    reportUnknownEntries(transport_, known);

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
}


void Foam::aleFluid::readStabilisation()
{
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


void Foam::aleFluid::findPressureReference()
{
    pRefNode_ = -1;
    pRefValue_ = schemes_.lookupOrDefault<scalar>("pRefValue", 0);
    if (!schemes_.found("pRefPoint")) return;

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


void Foam::aleFluid::checkPressureReference() const
{
    if (!schemes_.found("pRefPoint")) return;

    const auto fail = [&](const string& why)
    {
        FatalIOErrorInFunction(schemes_)
            << "Found pRefPoint, but " << why.c_str()
            << ", which gives the pressure its level. With pRefPoint the mass at"
            << " that point would not be balanced. Remove pRefPoint"
            << exit(FatalIOError);
    };
    for (const pointPatchVectorField& patch : pointU_().boundaryField())
    {
        // A steady wall does not give way
        if (motion_.follows(patch.patch().index()))
        {
            if (timeScheme().steady()) continue;
            fail("patch " + patch.patch().name() + " is on an interface with a solid that gives way");
        }
        else if (flowLoads::isOpen(patch) && !returnReduce(patch.patch().meshPoints().empty(), andOp<bool>()))
        {
            fail("patch " + patch.patch().name() + " lets the fluid out (" + patch.type() + ')');
        }
    }
    if (!incompressible()) fail("the fluid has a bulkModulus");
}


void Foam::aleFluid::initialise()
{
    v_ = rateField<vector>(fe().nNodes());
    q_ = rateField<scalar>(layout().size(PRESSURE));
    v_.v = fe().interpolate<vector>(pointU_->primitiveField());
    q_.v = scalarField(pointP_->primitiveField(), fe().vertexPoint());
    boundary_->project(v_.v, mesh_.time().timeOutputValue());
}


Foam::List<Foam::fieldLayout::field> Foam::aleFluid::fields() const
{
    typedef fieldLayout layout;
    return
    {
        {"pointU", layout::kind::VECTOR, layout::support::NODES, dimVelocity},
        {"pointP", layout::kind::SCALAR, layout::support::VERTICES, dimPressure},
    };
}


void Foam::aleFluid::makeFields()
{
    motion_.discretise(fe());
    boundary_.reset(new nodalBoundary(fe(), pointU_()));
    const bool first = returnReduce(v_.size() != fe().nNodes(), orOp<bool>());
    if (first) initialise();
    loads_.reset(new flowLoads(fe(), pointU_(), pointP_(), openPressure_, first));
    assembly_.reset(new flowAssembly(fe()));
    findPressureReference();
    if (first)
    {
        if (pRefNode_ != -1) q_.v[pRefNode_] = pRefValue_;
        boundary_->cyclic().follow(q_.v);
    }

    stage_ = flowFields(fe().nNodes(), layout().size(PRESSURE));
    meshAcceleration_.setSize(fe().nNodes());
    continuity_.setSize(layout().size(PRESSURE));
    faceArea_ = Foam::pow(fe().meanSize(), fe().dim() - 1);
}


void Foam::aleFluid::connected()
{
    checkPressureReference();
    motion_.connect(unknowns(), fe().blocks());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aleFluid::aleFluid(fvMesh& mesh, const dictionary& linearSolver)
:
    feRegion
    (
        mesh,
        elementFamilyNames.get("elements", readSchemes(mesh)) == elementFamily::TAYLOR_HOOD ? 2 : 1
    ),
    family_(elementFamilyNames.get("elements", schemes_)),
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
    motion_(mesh, linearSolver),
    stage_(0, 0)
{
    reportUnknownEntries
    (
        schemes_,
        {"elements", "stabilisation", "timeScheme", "curvedPatches", "pRefPoint", "pRefValue"}
    );
    k_.g = g_.value();
    readTransport();
    readStabilisation();
    nodalBoundary::check(pointP_());
    discretise();

    state_.add("U", fieldLayout::support::NODES, v_);
    state_.add("p", fieldLayout::support::VERTICES, q_);
    state_.add("meshDisplacement", fieldLayout::support::NODES, motion_.displacement());
    state_.add("openPressure", fieldLayout::support::NODES, openPressure_);
    state_.shift();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aleFluid::constrain(dofConstraints& c) const
{
    boundary_->constrain(unknowns(), VELOCITY, c, labelHashSet(motion_.following()));
    boundary_->cyclic().tie(unknowns(), PRESSURE, c);
    if (pRefNode_ != -1) c.fix(unknowns().start(PRESSURE, pRefNode_));
}


void Foam::aleFluid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    v_.predict(ts);
    incompressible() ? q_.predictStage(ts) : q_.predict(ts);

    boundary_->forValues(time, [&](const label n, const vector& u) { v_.set(ts, n, u); });
    vectorField v(v_.v);
    if (boundary_->project(v, time)) forAll(v, n) if (v[n] != v_.v[n]) v_.set(ts, n, v[n]);
    if (pRefNode_ != -1)
    {
        incompressible() ? q_.setStage(ts, pRefNode_, pRefValue_) : q_.set(ts, pRefNode_, pRefValue_);
    }
    loads_->predict();
    motion_.predict(ts, time);
}


void Foam::aleFluid::update(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    forAll(v_.v, n) v_.set(ts, n, v_.v[n] + unknowns().at(VELOCITY, n, dx));
    forAll(q_.v, i)
    {
        const scalar dp = dx[unknowns().start(PRESSURE, i)];
        if (incompressible()) q_.setStage(ts, i, q_.v[i] + ts.alphaF()*dp);
        else q_.set(ts, i, q_.v[i] + dp);
    }
}


void Foam::aleFluid::followed()
{
    const feTimeScheme& ts = timeScheme();
    const motionField& D = motion_.displacement();
    for (const label n : motion_.following())
    {
        v_.v[n] = ts.steady() ? vector::zero : D.v[n];
        v_.a[n] = ts.steady() ? vector::zero : D.a[n];
    }
    motion_.extend(ts);
}


void Foam::aleFluid::followedAtStart()
{
    motion_.extendRates();
}


void Foam::aleFluid::extendIncrement(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    motion_.extendIncrement(unknowns(), dx, ts.displacementByUnknown()/ts.alphaF());
}


Foam::scalar Foam::aleFluid::residualScale(const label field) const
{
    if (field == VELOCITY) return 0;
    scalar sum = 0;
    forAll(v_.v, n) if (unknowns().map().owned(unknowns().node(n))) sum += magSqr(v_.v[n]);
    return faceArea_*::sqrt(returnReduce(sum, sumOp<scalar>()));
}


Foam::scalar Foam::aleFluid::unknownScale(const label) const
{
    scalar size = 0;
    const vectorField& vm = motion_.displacement().v;
    forAll(v_.v, n) size = max(size, max(mag(v_.v[n]), mag(vm[n])));
    return returnReduce(size, maxOp<scalar>());
}


Foam::string Foam::aleFluid::singularAdvice(const label field) const
{
    return
        field == PRESSURE
      ? "The pressure is undetermined where no patch lets the fluid out: give one patch"
        " of pointU the type openBoundary, or pRefPoint in feSchemes"
      : "The velocity is undetermined: mu and rho must not both be zero";
}


void Foam::aleFluid::reportSolvers(Ostream& os) const
{
    if (const feLinearSolver* solver = motion_.solver())
    {
        os << "Factors of the mesh motion of " << name() << ": " << solver->stats() << nl;
    }
}


Foam::tmp<Foam::scalarField> Foam::aleFluid::endPressure() const
{
    tmp<scalarField> tp(new scalarField(q_.v));
    if (incompressible()) forAll(q_.v, i) tp.ref()[i] = q_.atEnd(timeScheme(), i);
    return tp;
}


void Foam::aleFluid::derive()
{
    fe().toPoints<vector>(v_.v, pointU_->primitiveFieldRef());

    // At all nodes: mid-side ones have the mean of their ends
    scalarField p(endPressure());
    p.setSize(fe().nNodes(), 0);
    for (label n = fe().nVertices(); n < p.size(); ++n)
    {
        for (const label m : fe().parents()[n]) p[n] += p[m]/fe().parents()[n].size();
    }
    fe().toPoints<scalar>(p, pointP_->primitiveFieldRef());
    motion_.derive();
    toCells<vector>(v_.v, U_);
    toCells<scalar>(p, p_);
}


// ************************************************************************* //
