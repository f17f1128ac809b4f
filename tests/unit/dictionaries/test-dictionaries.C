/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-dictionaries

Description
    Entries that nobody reads: the nearest valid word, macros, and
    which entries are reported.
\*---------------------------------------------------------------------------*/

#include "gtest/gtest.h"
#include "unknownEntries.H"
#include "nearestWord.H"
#include "dictionaryFiles.H"
#include "IFstream.H"
#include "OSspecific.H"
#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const fileName scratch("unknownEntries.scratch");


void writeFile(const fileName& name, const std::string& text)
{
    mkDir(scratch);
    std::ofstream(scratch/name) << text;
}


//- Write a file and read it as a dictionary
dictionary fileDict(const fileName& name, const std::string& text)
{
    writeFile(name, text);
    IFstream is(scratch/name);
    return dictionary(fileName(is.name()), dictionary::null, is);
}


//- What is reported of a dictionary
std::string report(const dictionary& dict, const wordList& valid)
{
    testing::internal::CaptureStdout();
    reportUnknownEntries(dict, valid);
    return testing::internal::GetCapturedStdout();
}


bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * *  Tests  * * * * * * * * * * * * * * * * //

TEST(nearestWord, distance)
{
    EXPECT_EQ(editDistance("gamma", "gamma"), 0);
    EXPECT_EQ(editDistance("Gamma", "gamma"), 0);
    EXPECT_EQ(editDistance("gama", "gamma"), 1);
    EXPECT_EQ(editDistance("gmama", "gamma"), 1);
    EXPECT_EQ(editDistance("gammma", "gamma"), 1);
    EXPECT_EQ(editDistance("gabba", "gamma"), 2);
    EXPECT_EQ(editDistance("", "gamma"), 5);
}


TEST(nearestWord, isTheOneMeant)
{
    const wordList words({"type", "ordering", "maxIter", "E", "nu", "rho"});
    EXPECT_EQ(nearestWord("ordxring", words), "ordering");
    EXPECT_EQ(nearestWord("maxIterations", words), "maxIter");
    EXPECT_EQ(nearestWord("tpye", words), "type");
    EXPECT_EQ(nearestWord("rh0", words), "rho");
    EXPECT_TRUE(nearestWord("Uinlet", words).empty());
    EXPECT_TRUE(nearestWord("v", words).empty());
    EXPECT_TRUE(nearestWord("type", wordList()).empty());
}


TEST(dictionaryFiles, macrosAndWords)
{
    writeFile("other", "c 1;\n d $e;\n");
    writeFile
    (
        "macros",
        "a $b; a2 ${c.d}; a3 $:f/g;\n#include \"other\"\n#calc \"2*$h\"\n$..i;\n"
    );
    const dictionaryFiles files(scratch/"macros");
    EXPECT_EQ(files.macros(), wordHashSet({"b", "c", "d", "e", "f", "g", "h", "i"}));
    EXPECT_EQ(files.with("a2"), scratch/"macros");
    EXPECT_EQ(files.with("e"), scratch/"other");
    EXPECT_TRUE(files.with("j").empty());
    EXPECT_TRUE(dictionaryFiles("noSuchFile").macros().empty());
}


TEST(unknownEntries, isReportedOnceWithFileLineAndNearestWord)
{
    const dictionary dict(fileDict("once", "sub\n{\n    type a;\n    gama 0.5;\n}\n"));
    const wordList valid({"type", "gamma", "beta"});

    const std::string text(report(dict.subDict("sub"), valid));
    EXPECT_TRUE(has(text, "once\" at line 4")) << text;
    EXPECT_TRUE(has(text, "Nobody reads the entry 'gama' of sub; did you mean 'gamma'?")) << text;
    EXPECT_TRUE(has(text, "Valid entries: type gamma beta")) << text;
    EXPECT_FALSE(has(text, "'type' of"));
    EXPECT_EQ(report(dict.subDict("sub"), valid), "");
}


TEST(unknownEntries, subDictionary)
{
    const dictionary dict(fileDict("subDict", "\nsovler\n{\n    type a;\n}\n"));
    const std::string text(report(dict, {"solver"}));
    EXPECT_TRUE(has(text, "'sovler'") && has(text, "'solver'") && has(text, "at line 4")) << text;
}


TEST(unknownEntries, regularExpressionThatMatchesIsValid)
{
    const dictionary dict(fileDict("regex", "\"(gamma|beta)\" 1; \"gam.*\" 2; \"xy.*\" 3;"));
    const std::string text(report(dict, {"gamma", "beta"}));
    EXPECT_FALSE(has(text, "gamma|") || has(text, "gam.*")) << text;
    EXPECT_TRUE(has(text, "xy.*")) << text;
}


TEST(unknownEntries, macroIsNoEntry)
{
    const dictionary dict(fileDict("macro", "speed 2; U $speed; sped 3;"));
    const std::string text(report(dict, {"U"}));
    EXPECT_FALSE(has(text, "'speed'")) << text;
    EXPECT_TRUE(has(text, "'sped'")) << text;
}


TEST(unknownEntries, includedVariablesAreNone)
{
    writeFile("settings", "inflow 2;\n\ngama 3;\n");
    const dictionary dict(fileDict("includer", "#include \"settings\"\ninflow2 1;\n"));
    const std::string text(report(dict, {"gamma"}));
    EXPECT_FALSE(has(text, "'inflow'")) << text;
    EXPECT_TRUE(has(text, "settings\" at line 3") && has(text, "'gama'")) << text;
    EXPECT_TRUE(has(text, "includer\" at line 2") && has(text, "'inflow2'")) << text;
}


TEST(unknownEntries, withoutAFile)
{
    dictionary dict("inMemory");
    dict.add("gama", 1);
    dict.add("gamma", 1);
    const std::string text(report(dict, {"gamma"}));
    EXPECT_TRUE(has(text, "'gama'")) << text;
}


int main(int argc, char* argv[])
{
    testing::InitGoogleTest(&argc, argv);
    const int status = RUN_ALL_TESTS();
    rmDir(scratch);
    return status;
}


// ************************************************************************* //
