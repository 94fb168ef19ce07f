// Opens each description whose path is on the standard input as CANopenEditor does, and prints the path, a tab and `opened`,
// `dropped` where it skips a section, or why it does not open the file.
using System;
using System.IO;
using libEDSsharp;

static class Editor
{
    static void Main()
    {
        TextWriter answers = Console.Out;
        string path;
        while ((path = Console.In.ReadLine()) != null)
        {
            StringWriter said = new StringWriter();
            Console.SetOut(said);
            answers.WriteLine(path + "\t" + Open(path, said));
        }
    }

    static string Open(string path, StringWriter said)
    {
        try
        {
            if (path.EndsWith(".eds") || path.EndsWith(".dcf"))
                new EDSsharp().Loadfile(path);
            else if (new CanOpenXDD_1_1().ReadXML(path) == null && new CanOpenXDD().readXML(path) == null)
                return "not an XDD of version 1.1 or 1.0";
            return said.ToString().Contains("ALL GONE WRONG") ? "dropped " + said : "opened";
        }
        catch (Exception error)
        {
            return error.GetType().Name + ": " + error.Message.Replace("\n", " ");
        }
    }
}
