"""Pictures of results, drawn by matplotlib, and the scenery of a section, which the live page draws as well."""
