/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unknownEntries.H"
#include "dictionaryFiles.H"
#include "nearestWord.H"
#include "messageStream.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- File in the name of a dictionary, which is <file>.<entry>...;
//  empty where there is none
static fileName fileIn(fileName name)
{
    while (!isFile(name))
    {
        const auto dot = name.rfind('.');
        if (dot == string::npos || dot < name.rfind('/') + 1) return fileName();
        name.resize(dot);
    }
    return name;
}


static bool isKnown(const keyType& key, const wordList& valid)
{
    if (key == "FoamFile") return true;
    for (const word& name : valid) if (key.match(name)) return true;
    return false;
}


//- Not met before in this run
static bool isNew(const dictionary& dict, const entry& e)
{
    static HashSet<string> met;
    return met.insert(dict.name() + '.' + e.keyword());
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::reportUnknownEntries
(
    const dictionary& dict,
    const wordList& valid
)
{
    if (!Pstream::master()) return;

    const fileName file(fileIn(dict.name()));
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        if (isKnown(key, valid)) continue;

        const word nearest(nearestWord(key, valid));
        const dictionaryFiles files(file);
        const fileName origin(files.with(key));
        const bool included = !origin.empty() && origin != file;
        const bool variable = (included && nearest.empty()) || files.macros().found(key);
        if (variable || !isNew(dict, e)) continue;

        OSstream& os = Warning
        (
            FUNCTION_NAME, __FILE__, __LINE__,
            origin.empty() ? dict.name() : origin,
            e.startLineNumber(), e.endLineNumber()
        );
        os  << "Nobody reads the entry '" << key << "' of " << dict.dictName();
        if (!nearest.empty()) os << "; did you mean '" << nearest << "'?";
        os  << nl << "    Valid entries:";
        for (const word& name : valid) os << ' ' << name;
        os  << nl << endl;
    }
}


// ************************************************************************* //
