/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    materialCurve

Description
    Curves of a material in the tests of a laboratory (materialTest), beside
    measured ones, and the coefficients of MooneyRivlin that fit these best.
    Reads system/materialCurveDict:

    \verbatim
    // The material whose curves are wanted: that of a region, or material {...};
    // absent where it is fitted
    region      solid;
    name        spring;         // of its list; absent: the first

    // Measured loads per undeformed area: (stretch, shear or volume; Pa)
    tests
    {
        uniaxial    ((1 0) (1.24 0.2256e6) ...);
        equibiaxial (...);      // planar, shear, volumetric
    }

    // Optional: MooneyRivlin, incompressible, from the tests
    fit
    {
        coefficients    (c1 c2 c3);     // c1 .. c9
        weights         relative;       // default; or absolute
        rho             1100;           // of the material that is printed
    }

    range       (0.5 3);        // stretches of the curves; shears x - 1. Those of
                                // measured tests go as far as the measured points
    nPoints     50;             // default
    \endverbatim

    Writes postProcessing/materialCurve/<test>.dat (x, load in Pa), a plot of all
    by gnuplot, materialCurve.gp, and in 0/materialCurve.dat the root mean squares
    of the relative deviations from the tests. It warns where a load falls as the
    stretch grows: there the material is not stable.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "mooneyRivlinFit.H"
#include "unknownEntries.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const materialTest::mode allModes[] =
{
    materialTest::mode::UNIAXIAL, materialTest::mode::EQUIBIAXIAL, materialTest::mode::PLANAR,
    materialTest::mode::SHEAR, materialTest::mode::VOLUMETRIC
};

static measuredLoads readTests(const dictionary& dict)
{
    measuredLoads measured;
    if (!dict.found("tests")) return measured;
    for (const entry& e : dict.subDict("tests"))
    {
        const auto m = materialTest::modeNames.get(e.keyword());
        measured.insert(label(m), dict.subDict("tests").get<List<Tuple2<scalar, scalar>>>(e.keyword()));
    }
    return measured;
}


//- The material's dictionary: given here, in a region's list, or fitted
static dictionary readMaterial(const Time& time, const dictionary& dict, const measuredLoads& measured)
{
    if (dict.found("fit"))
    {
        dictionary fit(dict.subDict("fit"));
        const scalar rho = fit.lookupOrDefault<scalar>("rho", 1000);
        fit.remove("rho");
        dictionary material(mooneyRivlinFit(fit, measured));
        material.add("rho", rho);
        return material;
    }
    if (dict.found("material")) return dict.subDict("material");
    const IOdictionary properties
    (
        IOobject("mechanicalProperties", time.constant(), dict.get<word>("region"), time, IOobject::MUST_READ)
    );
    const PtrList<entry> entries(properties.lookup("materials"));
    wordList names;
    for (const entry& e : entries)
    {
        if (!dict.found("name") || e.keyword() == dict.get<word>("name")) return e.dict();
        names.append(e.keyword());
    }
    FatalIOErrorInFunction(dict)
        << "There is no material " << dict.get<word>("name") << ". Materials: " << names << exit(FatalIOError);
    return dictionary();
}


//- A curve, and where it falls
static void writeCurve
(
    const materialTest& test,
    const materialTest::mode m,
    const Tuple2<scalar, scalar>& range,
    const label nPoints,
    const fileName& dir
)
{
    const word name(materialTest::modeNames[m]);
    OFstream os(dir/(name + ".dat"));
    os.precision(12);
    scalar last = -GREAT, falls = -1;
    for (label i = 0; i <= nPoints; ++i)
    {
        const scalar l = range.first() + (range.second() - range.first())*i/nPoints;
        const scalar load = test.load(m, l);
        const scalar rise = m == materialTest::mode::VOLUMETRIC ? -load : load;
        if (rise < last && falls < 0) falls = l;
        last = rise;
        os << l << ' ' << load << nl;
    }
    if (falls < 0) return;
    WarningInFunction
        << "The load of the test " << name << " falls as it goes on at " << falls
        << ": the material is not stable there" << endl;
}


//- Of the measured points, or of the dictionary
static Tuple2<scalar, scalar> rangeOf
(
    const materialTest::mode m,
    const measuredLoads& measured,
    const dictionary& dict
)
{
    auto range(dict.lookupOrDefault<Tuple2<scalar, scalar>>("range", {0.5, 3}));
    if (m == materialTest::mode::SHEAR) range = {range.first() - 1, range.second() - 1};
    const auto found = measured.cfind(label(m));
    if (!found.found()) return range;
    range = {GREAT, -GREAT};
    for (const auto& point : *found)
    {
        range = {min(range.first(), point.first()), max(range.second(), point.first())};
    }
    return range;
}


static void writePlot(const wordList& modes, const measuredLoads& measured, const fileName& dir)
{
    OFstream os(dir/"materialCurve.gp");
    os  << "set terminal pngcairo size 600,400\nset output 'materialCurve.png'\n"
        << "set xlabel 'stretch, shear, volume ratio'\nset ylabel 'load [MPa]'\nset key top left\nplot \\" << nl;
    forAll(modes, i)
    {
        os  << "    'postProcessing/materialCurve/" << modes[i].c_str() << ".dat' using 1:($2/1e6) with lines linetype "
            << i + 1 << " title '" << modes[i].c_str() << '\'';
        const auto found = measured.cfind(label(materialTest::modeNames.get(modes[i])));
        if (found.found())
        {
            const fileName points("measured." + modes[i]);
            OFstream data(dir/points);
            for (const auto& point : *found) data << point.first() << ' ' << point.second() << nl;
            os  << ", 'postProcessing/materialCurve/" << points.c_str()
                << "' using 1:($2/1e6) with points pointtype 7 linetype " << i + 1 << " notitle";
        }
        os << (i + 1 < modes.size() ? ", \\" : "") << nl;
    }
}


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    argList::noParallel();
    argList::addNote("Curves of a material and a fit to tests: system/materialCurveDict");
    argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    const IOdictionary dict
    (
        IOobject("materialCurveDict", runTime.system(), runTime, IOobject::MUST_READ, IOobject::NO_WRITE, false)
    );
    reportUnknownEntries(dict, {"region", "name", "material", "tests", "fit", "range", "nPoints"});

    const measuredLoads measured(readTests(dict));
    const dictionary materialDict(readMaterial(runTime, dict, measured));
    Info<< "Material" << nl << materialDict << nl;
    const autoPtr<solidMaterial> law = solidMaterial::New(materialDict);
    const materialTest test(law());

    const auto* mixed = dynamic_cast<const mixedMaterial*>(law.get());
    const label nPoints = dict.lookupOrDefault<label>("nPoints", 50);
    const fileName dir(runTime.globalPath()/"postProcessing"/"materialCurve");
    mkDir(dir/"0");
    wordList modes;
    for (const auto m : allModes)
    {
        if (m == materialTest::mode::VOLUMETRIC && mixed && mixed->rKappa() == 0) continue;
        writeCurve(test, m, rangeOf(m, measured, dict), nPoints, dir);
        modes.append(materialTest::modeNames[m]);
    }
    writePlot(modes, measured, dir);

    OFstream os(dir/"0"/"materialCurve.dat");
    os << "# Time";
    forAllConstIters(measured, iter) os << ' ' << materialTest::modeNames[materialTest::mode(iter.key())];
    os << nl << 0;
    forAllConstIters(measured, iter)
    {
        const auto m = materialTest::mode(iter.key());
        const scalar rms = deviation(test, m, iter.val());
        Info<< "Deviation from the test " << materialTest::modeNames[m] << ": " << 100*rms << " %" << nl;
        os << ' ' << rms;
    }
    os << endl;
    Info<< nl << "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
