/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "coastingScheme.H"
#include "flowStabilisation.H"
#include "movesWithMesh.H"
#include "patchIntegrals.H"
#include "readNumber.H"
#include "readTurbulence.H"
#include "startFunctions.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(aleFluid, 0);
    addToRunTimeSelectionTable(feRegion, aleFluid, mesh);
}

const Foam::Enum<Foam::flowFamily> Foam::aleFluid::familyNames
({
    {flowFamily::EQUAL_ORDER, "equalOrder"},
    {flowFamily::TAYLOR_HOOD, "taylorHood"},
    {flowFamily::Q1Q0, "Q1Q0"},
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

enum class densityLaw { CONSTANT, EXPONENTIAL };

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aleFluid::readTransport()
{
    // Users' files say Newtonian, which is what there is
    wordList known({"rho", "mu", "nu", "bulkModulus", "density", "p0"});
    if (transport_.lookupOrDefault<word>("transportModel", "") == "Newtonian") known.append("transportModel");
    reportUnknownEntries(transport_, known);

    k_.rho = readNumber(transport_, "rho", dimDensity, 0, VGREAT);
    if (transport_.found("mu"))
    {
        k_.mu = readNotNegative(transport_, "mu", dimDynamicViscosity);
        // Stock function objects (forces) look for nu
        transport_.set("nu", dimensionedScalar("nu", dimViscosity, k_.mu/k_.rho));
    }
    else
    {
        k_.mu = k_.rho*readNotNegative(transport_, "nu", dimViscosity);
    }
    if (transport_.found("bulkModulus"))
    {
        k_.rBulk = 1/readNumber(transport_, "bulkModulus", dimPressure, 0, VGREAT);
    }

    const Enum<densityLaw> laws({{densityLaw::CONSTANT, "constant"}, {densityLaw::EXPONENTIAL, "exponential"}});
    k_.denser = laws.lookupOrDefault("density", transport_, densityLaw::CONSTANT) == densityLaw::EXPONENTIAL;
    k_.p0 = dimensionedScalar("p0", dimPressure, 0, transport_).value();
    if (k_.denser && incompressible())
    {
        FatalIOErrorInFunction(transport_)
            << "Found density exponential without bulkModulus: an incompressible fluid has"
            << " density constant" << exit(FatalIOError);
    }
}


void Foam::aleFluid::checkCells() const
{
    if (!cellPressure()) return;
    const auto others = [](const elementBlock& block)
    {
        return block.shape == elementShape::QUAD || block.shape == elementShape::HEX ? 0 : block.size();
    };
    label n = 0;
    point where = point::max;
    for (const elementBlock& block : fe().blocks())
    {
        if (!others(block)) continue;
        n += block.size();
        where = mesh_.cellCentres()[block.cells[0]];
    }
    reduce(n, sumOp<label>());
    reduce(where, minOp<point>());
    if (!n) return;
    FatalIOErrorInFunction(schemes_)
        << "Elements Q1Q0 are for quadrilaterals and hexahedra; found " << n
        << " other cells, one at " << where << '.' << nl
        << "One pressure to a triangle or tetrahedron (P1P0) leaves the velocity too few freedoms"
        << " and locks. Choose equalOrder, which takes all cells, or taylorHood"
        << exit(FatalIOError);
}


void Foam::aleFluid::findMacros()
{
    const wordList choices({"all", "macroElements"});
    const word modes(schemes_.lookupOrDefault<word>("pressureModes", choices[0]));
    if (!choices.found(modes) || (modes == choices[1] && !cellPressure()))
    {
        FatalIOErrorInFunction(schemes_)
            << "Found pressureModes " << modes << " with elements " << familyNames[k_.family]
            << ". Valid: " << choices << ", the second with Q1Q0" << exit(FatalIOError);
    }
    const bool first = !assembly_.valid();
    if (first && cellPressure() && !incompressible() && motion_.moving())
    {
        Info<< "Region " << name() << ": with Q1Q0 the mesh does not carry the pressure of a barotropic fluid,"
            << " vm.grad(p)/B: small beside div(v) where the fluid is stiff; else choose equalOrder or taylorHood"
            << nl;
    }
    const bool closed = cellPressure() && schemes_.found("pRefPoint");
    if (modes == choices[0] && !(first && closed)) return;
    macros_.reset(new pressureMacros(fe()));
    if (first)
    {
        Info<< "Region " << name() << ": " << macros_->nGroups() << " groups of " << (fe().dim() == 2 ? 4 : 8)
            << (
                   modes == choices[0]
                 ? " cells, each of which may have a checkerboard of the pressure, which a closed cavity of equal"
                   " cells leaves undetermined: pressureModes macroElements leaves it out"
                 : " cells have pressures without checkerboards (pressureModes macroElements)"
               ) << nl;
    }
    if (modes == choices[0]) macros_.clear();
}


void Foam::aleFluid::findMovingWalls()
{
    DynamicList<label> nodes;
    for (const pointPatchVectorField& patch : pointU_().boundaryField())
    {
        if (!dynamic_cast<const movesWithMesh*>(&patch)) continue;
        const word& wall = patch.patch().name();
        if (!motion_.gives(patch.patch().index()))
        {
            FatalErrorInFunction
                << "Region " << name() << ": pointU is of type " << patch.type() << " on patch " << wall
                << ", where pointDisplacement gives no motion." << nl
                << "Give it a type with values there (nodalProfile, say), and the region a"
                << " constant/" << name() << "/dynamicMeshDict, or pointU the type fixedValue"
                << exit(FatalError);
        }
        for (const label n : fe().patchNodes(patch.patch().index()))
        {
            if (boundary_->patchName(n) == wall) nodes.append(n);
        }
    }
    wallNodes_ = nodes;
}


void Foam::aleFluid::findPressureReference()
{
    pRefNode_ = -1;
    pRefValue_ = schemes_.lookupOrDefault<scalar>("pRefValue", 0);
    if (!schemes_.found("pRefPoint")) return;

    scalar distance;
    const auto findNearest = [&](const point& x)
    {
        distance = GREAT;
        forAll(q_.v, n)
        {
            if (mag(pressurePoint(n) - x) >= distance || (macros_.valid() && macros_->follows(n))) continue;
            distance = mag(pressurePoint(n) - x);
            pRefNode_ = n;
        }
    };

    // The value of the first rank that has a nearest one, and its copies
    findNearest(schemes_.get<point>("pRefPoint"));
    label owner = distance > returnReduce(distance, minOp<scalar>()) ? labelMax : Pstream::myProcNo();
    reduce(owner, minOp<label>());
    point at = owner == Pstream::myProcNo() ? pressurePoint(pRefNode_) : point::max;
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


void Foam::aleFluid::checkFluxes(const scalar time) const
{
    if (!schemes_.found("pRefPoint")) return;
    labelList patches;
    for (const polyPatch& pp : mesh_.boundaryMesh()) if (!pp.coupled()) patches.append(pp.index());
    const vectorField x(fe().points() + motion_.displacement().D);
    const patchIntegrals at(fe(), patches, x, v_.v, scalarField(fe().nNodes(), 0));

    // Profiles that are given on meshes of different fineness differ a little
    if (mag(at.flux) <= 0.01*at.magFlux) return;
    const scalar in = (at.magFlux - at.flux)/2, out = (at.magFlux + at.flux)/2;
    FatalErrorInFunction
        << "Region " << name() << " is closed and its fluid incompressible, but at time " << time
        << " the velocities on its boundary let in " << in << " and out " << out
        << (fe().dim() == 2 ? " m2/s, that is " : " m3/s, that is ") << mag(at.flux)
        << (at.flux > 0 ? " more out than in." : " more in than out.") << nl
        << "Give velocities that balance, or let the fluid out through an openBoundary (without"
        << " pRefPoint)" << exit(FatalError);
}


void Foam::aleFluid::initialise()
{
    v_ = rateField<vector>(fe().nNodes());
    q_ = rateField<scalar>(layout().size(PRESSURE));
    v_.v = fe().interpolate<vector>(pointU_->primitiveField());
    q_.v = scalarField(pointP_->primitiveField(), fe().vertexPoint());
    const startFunctions start(mesh_, {"pointU", "pointP"});
    start.set("pointU", fe().points(), v_.v);
    start.set("pointP", fe().points(), q_.v);
    if (fe().dim() == 2) for (vector& v : v_.v) v[fe().axis(2)] = 0;
    if (cellPressure())
    {
        const scalarField p(q_.v);
        q_ = rateField<scalar>(mesh_.nCells());
        for (const elementBlock& block : fe().blocks()) for (label e = 0; e < block.size(); ++e)
        {
            for (label i = 0; i < block.nNodes; ++i)
            {
                q_.v[block.cells[e]] += p[block.element(e)[i]]/block.nNodes;
            }
        }
    }
    boundary_->project(v_.v, mesh_.time().timeOutputValue());
}


Foam::List<Foam::fieldLayout::field> Foam::aleFluid::fields() const
{
    typedef fieldLayout layout;
    return
    {
        {"pointU", layout::kind::VECTOR, layout::support::NODES, dimVelocity},
        {cellPressure() ? "p" : "pointP", layout::kind::SCALAR, pressureOn(), dimPressure},
    };
}


Foam::fieldLayout::support Foam::aleFluid::pressureOn() const
{
    return cellPressure() ? fieldLayout::support::CELLS : fieldLayout::support::VERTICES;
}


Foam::point Foam::aleFluid::pressurePoint(const label value) const
{
    return cellPressure() ? mesh_.cellCentres()[value] : fe().points()[value];
}


void Foam::aleFluid::makeFields()
{
    checkCells();
    motion_.discretise(fe());
    boundary_.reset(new nodalBoundary(fe(), pointU_()));
    boundary_->setReference(motion_.reference().now);
    const bool first = returnReduce(v_.size() != fe().nNodes(), orOp<bool>());
    if (first) initialise();
    findMovingWalls();
    loads_.reset(new flowLoads(fe(), pointU_(), pointP_(), openPressure_, first));
    findMacros();
    assembly_.reset(new flowAssembly(fe()));
    if (k_.tracked) subscales_.setSize(assembly_->nPoints(), mesh_.nCells());
    findPressureReference();
    if (first)
    {
        if (pRefNode_ != -1) q_.v[pRefNode_] = pRefValue_;
        if (!cellPressure()) boundary_->cyclic().follow(q_.v);
        if (macros_.valid()) macros_->project(q_.v);
    }

    stage_ = flowFields(fe().nNodes(), layout().size(PRESSURE));
    meshAcceleration_.setSize(fe().nNodes());
    continuity_.setSize(layout().size(PRESSURE));
    faceArea_ = Foam::pow(fe().meanSize(), fe().dim() - 1);
}


void Foam::aleFluid::makeOutput()
{
    const auto io = [&](const word& name)
    {
        return IOobject(name, mesh_.time().timeName(), mesh_, IOobject::NO_READ, IOobject::AUTO_WRITE);
    };
    if (k_.eddyConstant > 0)
    {
        nut_.reset(new volScalarField(io("nut"), mesh_, dimensionedScalar(dimViscosity, Zero)));
    }
    if (cellPressure())
    {
        smoothedP_.reset
        (
            new pointScalarField
            (
                io("pointPSmoothed"), pointP_->mesh(), dimensionedScalar(dimPressure, Zero)
            )
        );
    }
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
        familyNames.get("elements", readSchemes(mesh)) == flowFamily::TAYLOR_HOOD ? 2 : 1
    ),
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
    wordList known({"elements", "timeScheme", "curvedPatches", "pRefPoint", "pRefValue", "pressureModes"});
    known.append(flowStabilisation::entries(schemes_));
    reportUnknownEntries(schemes_, known);
    k_.family = familyNames.get("elements", schemes_);
    k_.g = g_.value();
    readTransport();
    filter_ = readTurbulence(mesh, k_);
    flowStabilisation::New(schemes_, k_.family)->set(k_);
    makeOutput();
    nodalBoundary::check(pointP_());
    discretise();

    state_.add("U", fieldLayout::support::NODES, v_);
    state_.add("p", pressureOn(), q_);
    state_.add("meshReference", fieldLayout::support::NODES, motion_.reference());
    state_.add("meshDisplacement", fieldLayout::support::NODES, motion_.displacement());
    state_.add("openPressure", fieldLayout::support::NODES, openPressure_);
    state_.add("subscale", fieldLayout::support::CELLS, subscales_);
    state_.shift();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aleFluid::constrain(dofConstraints& c) const
{
    boundary_->constrain(unknowns(), VELOCITY, c, labelHashSet(motion_.following()));
    if (!cellPressure()) boundary_->cyclic().tie(unknowns(), PRESSURE, c);
    if (macros_.valid()) macros_->tie(unknowns(), PRESSURE, c);
    if (pRefNode_ != -1) c.fix(unknowns().start(PRESSURE, pRefNode_));
}


void Foam::aleFluid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    if (filter_.valid()) filter_->update(fe(), v_.v, k_.mu/k_.rho);
    const bool coasting = coastingScheme::on(ts);
    v_.predict(ts);
    incompressible() ? q_.predictStage(ts) : q_.predict(ts);

    if (!coasting)
    {
        boundary_->forValues(time, [&](const label n, const vector& u) { v_.set(ts, n, u); });
        vectorField v(v_.v);
        if (boundary_->project(v, time)) forAll(v, n) if (v[n] != v_.v[n]) v_.set(ts, n, v[n]);
    }
    if (pRefNode_ != -1)
    {
        incompressible() ? q_.setStage(ts, pRefNode_, pRefValue_) : q_.set(ts, pRefNode_, pRefValue_);
    }
    loads_->predict();
    motion_.predict(ts, time);
    for (const label n : wallNodes_) v_.set(ts, n, motion_.displacement().v[n]);
    if (!coasting) checkFluxes(time);
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


Foam::scalar Foam::aleFluid::unknownScale(const label field) const
{
    scalar size = 0, pressure = 0;
    for (const scalar p : q_.v) pressure = max(pressure, mag(p));
    reduce(pressure, maxOp<scalar>());
    if (field == PRESSURE) return pressure;

    // Weight and pressure, which may balance, move the fluid by this if they do not
    const vectorField& vm = motion_.displacement().v;
    forAll(v_.v, n) size = max(size, max(mag(v_.v[n]), mag(vm[n])));
    reduce(size, maxOp<scalar>());
    const scalar h = fe().meanSize(), force = k_.rho*mag(k_.g) + pressure/h;
    const feTimeScheme& ts = timeScheme();
    if (!ts.steady()) return size + force*ts.deltaT()/k_.rho;
    return k_.mu > 0 ? size + force*sqr(h)/k_.mu : size;
}


Foam::string Foam::aleFluid::singularAdvice(const label field) const
{
    if (field == PRESSURE && cellPressure() && schemes_.found("pRefPoint"))
    {
        return "With Q1Q0 in a closed cavity of equal cells pressures in the pattern of a"
            " checkerboard are undetermined: choose pressureModes macroElements in feSchemes,"
            " or elements equalOrder or taylorHood";
    }
    return
        field == PRESSURE
      ? "The pressure is undetermined where no patch lets the fluid out: give one patch"
        " of pointU the type openBoundary, or pRefPoint in feSchemes"
      : "The velocity is undetermined: mu and rho must not both be zero";
}


void Foam::aleFluid::reportSolvers(Ostream& os) const
{
    for (const feLinearSolver* solver : motion_.solvers())
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


void Foam::aleFluid::advance()
{
    if (k_.tracked) assembly_->subscales(k_, stage_, subscales_.now);
    motion_.movePoints();
}


Foam::tmp<Foam::scalarField> Foam::aleFluid::nodalPressure() const
{
    tmp<scalarField> tp(endPressure());
    if (cellPressure())
    {
        // Mean of the cells around a node
        const scalarField cells(tp);
        tp = tmp<scalarField>(new scalarField(fe().nNodes(), 0));
        scalarField n(fe().nNodes(), 0);
        for (const elementBlock& block : fe().blocks()) for (label e = 0; e < block.size(); ++e)
        {
            for (label i = 0; i < block.nNodes; ++i)
            {
                tp.ref()[block.element(e)[i]] += cells[block.cells[e]];
                n[block.element(e)[i]] += 1;
            }
        }
        fe().copies().sum(tp.ref());
        fe().copies().sum(n);
        tp.ref() /= n;
        return tp;
    }

    // Mid-side nodes have the mean of their ends
    scalarField& p = tp.ref();
    p.setSize(fe().nNodes(), 0);
    for (label n = fe().nVertices(); n < p.size(); ++n)
    {
        for (const label m : fe().parents()[n]) p[n] += p[m]/fe().parents()[n].size();
    }
    return tp;
}


Foam::tmp<Foam::scalarField> Foam::aleFluid::density() const
{
    return k_.rho*exp(k_.rBulk*(nodalPressure() - k_.p0));
}


void Foam::aleFluid::derive()
{
    fe().toPoints<vector>(v_.v, pointU_->primitiveFieldRef());
    const scalarField p(nodalPressure());
    pointScalarField& atPoints = cellPressure() ? smoothedP_() : pointP_();
    fe().toPoints<scalar>(p, atPoints.primitiveFieldRef());
    motion_.derive();
    toCells<vector>(v_.v, U_);
    toCells<scalar>(p, p_);
    if (cellPressure()) p_.primitiveFieldRef() = endPressure();
    if (nut_.valid()) assembly_->eddyViscosity(k_, stage_, nut_->primitiveFieldRef());
}


// ************************************************************************* //
